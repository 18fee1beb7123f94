//! Fortran: the hosts in hosts/fortran run.

use super::program::{built, compiler, root, run, scratch, succeed, watched};
use std::fs;
use std::process::Command;

/// What a host prints, plainly and under valgrind, with every check that the compiler offers.
pub(crate) fn output(host: &str) -> String {
    let folder = scratch(host);
    let mut fortran = compiler("FC", "gfortran");
    fortran.current_dir(&folder).args(["-std=f2018", "-Wall", "-Wextra", "-Werror", "-g", "-fcheck=all"]);
    fortran.args(["-ffp-contract=off", "-o", "host"]);
    fortran.args(["fmc_contact_c.f90", "fmc_contact.f90"].map(|name| root().join("bindings/fortran").join(name)));
    fortran.arg(root().join("hosts/fortran").join(host)).arg(built().join("libfmc_contact.a"));
    succeed(fortran.args(["-lpthread", "-ldl", "-lm"]));
    let plain = run(&mut Command::new(folder.join("host")));
    let printed = String::from_utf8_lossy(&plain.stdout).into_owned();
    let complaints = String::from_utf8_lossy(&plain.stderr).into_owned();
    assert!(plain.status.success() && complaints.is_empty(), "{host}: {}\n{printed}{complaints}", plain.status);
    if let Some(watched) = watched(&folder.join("host"), &[]) {
        assert_eq!(watched, printed, "{host} under valgrind");
    }
    printed
}

#[test]
fn two_squares_in_fifteen_lines_of_fortran() {
    let source = fs::read_to_string(root().join("hosts/fortran/two_squares.f90")).expect("the smallest host");
    let code = source.lines().filter(|line| !line.starts_with('!')).count();
    assert!(code <= 15, "{code} lines");
    let printed = output("two_squares.f90");
    assert!(printed.starts_with("overlap 0.008\nnode 1"), "{printed}");
    let forces: Vec<f64> = printed
        .lines()
        .skip(1)
        .map(|line| line.split_whitespace().nth(2).and_then(|word| word.parse().ok()).expect("a number"))
        .collect();
    // k times the depth times the height of the overlap, less at its corners, over 0.01 of 0.8.
    assert!((forces[..4].iter().sum::<f64>() + 800.0).abs() < 10.0, "{printed}");
    assert!((forces[4..].iter().sum::<f64>() - 800.0).abs() < 10.0, "{printed}");
}

#[test]
fn what_a_fortran_host_gets_is_right() {
    let printed = output("walk_through.f90");
    assert_eq!(printed, "cell or facet 2 names node 9, but there are 8 nodes, counted from 1\n0 failures\n");
}
