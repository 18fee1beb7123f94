//! The README's programs in C, C++ and Fortran are compiled and run as they stand there.

use super::program::{built, compiler, root, scratch, succeed};
use std::fs;
use std::process::Command;

/// The README's program in a language, at most ten lines of it.
pub(crate) fn first_force(language: &str) -> String {
    let readme = fs::read_to_string(root().join("README.md")).expect("the README");
    let fence = format!("```{language}\n");
    let source = readme.split(&fence).nth(1).and_then(|rest| rest.split("```").next()).expect("a program");
    assert!(source.lines().count() <= 10, "first force in ten lines");
    source.to_owned()
}

/// The overlap is 0.01 wide and 0.8 high; k times both pushes the squares apart, less at their corners, over 0.01 of 0.8.
pub(crate) fn pushes_two_squares_apart(printed: &str) -> bool {
    let x = |line: &str| line.split_whitespace().nth(2).and_then(|word| word.parse::<f64>().ok()).expect("a force");
    let forces: Vec<f64> = printed.lines().map(x).collect();
    let (left, right): (f64, f64) = (forces[..4].iter().sum(), forces[4..].iter().sum());
    forces.len() == 8 && (left + 800.0).abs() < 10.0 && (right - 800.0).abs() < 10.0
}

#[test]
fn the_readme_programs_print_the_forces_of_two_squares() {
    for (language, mut command) in [("c", compiler("CC", "cc")), ("cpp", compiler("CXX", "c++"))] {
        let folder = scratch(&format!("readme-{language}"));
        let (file, squares) = (folder.join("squares").with_extension(language), folder.join("squares"));
        fs::write(&file, first_force(language)).expect("a writable folder");
        command.args(["-Wall", "-Wextra", "-Werror", "-I"]).arg(root().join("include")).arg("-o").arg(&squares);
        succeed(command.arg(&file).arg(built().join("libfmc_contact.a")).args(["-lpthread", "-ldl", "-lm"]));
        let printed = succeed(&mut Command::new(&squares));
        assert!(pushes_two_squares_apart(&printed), "{language}: {printed}");
    }
}

#[test]
fn the_fortran_program_prints_the_forces_of_two_squares() {
    let folder = scratch("readme-fortran");
    fs::write(folder.join("squares.f90"), first_force("fortran")).expect("a writable folder");
    let mut command = compiler("FC", "gfortran");
    command.current_dir(&folder);
    command.args(["fmc_contact_c.f90", "fmc_contact.f90"].map(|name| root().join("bindings/fortran").join(name)));
    command.args(["squares.f90", "-o", "squares"]).arg(built().join("libfmc_contact.a"));
    succeed(command.args(["-lpthread", "-ldl", "-lm"]));
    let printed = succeed(&mut Command::new(folder.join("squares")));
    assert!(pushes_two_squares_apart(&printed), "{printed}");
}
