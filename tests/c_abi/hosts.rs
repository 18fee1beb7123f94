//! The hosts in hosts/c and hosts/cpp, and the programs in benchmarks/host_checks: compiled without a warning, run, and run again under valgrind.

use super::program::{built, compiler, is_sanitized, root, run, scratch, shared_library, succeed, watched};
use super::symbols::declared;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What a static link needs beside the library (`rustc --print native-static-libs`).
const NATIVE: [&str; 3] = ["-lpthread", "-ldl", "-lm"];

#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Link {
    Shared,
    Static,
}

/// A host to start from, or a program that checks the interface.
fn place(language: &str, source: &str) -> PathBuf {
    let host = root().join("hosts").join(language).join(source);
    if host.exists() { host } else { root().join("benchmarks/host_checks").join(language).join(source) }
}

/// Compiles a host into `folder`, against the library of this build.
fn compile(source: &str, folder: &Path, link: Link) -> PathBuf {
    let (mut command, language) = match source.ends_with(".cpp") {
        true => (compiler("CXX", "c++"), "cpp"),
        false => (compiler("CC", "cc"), "c"),
    };
    command.args(if language == "cpp" { ["-std=c++17", "-Wconversion"] } else { ["-std=c99", "-Wstrict-prototypes"] });
    command.args(["-g", "-O1", "-ffp-contract=off", "-pedantic", "-Wall", "-Wextra", "-Werror", "-I"]);
    command.arg(root().join("include"));
    let program = folder.join(source.replace('.', "_"));
    command.arg("-o").arg(&program).arg(place(language, source));
    match link {
        Link::Shared => {
            command.arg(shared_library(folder)).arg(format!("-Wl,-rpath,{}", folder.display()));
        }
        Link::Static => {
            command.arg(built().join("libfmc_contact.a")).args(NATIVE);
        }
    }
    succeed(command.args(["-lm", "-pthread"]));
    program
}

/// Runs a host, plainly and under valgrind: it must succeed, print the same, and leave standard error empty.
pub(crate) fn output(source: &str, link: Link) -> String {
    let name = format!("{source}-{}", if link == Link::Shared { "shared" } else { "static" });
    let program = compile(source, &scratch(&name), link);
    let plain = run(&mut Command::new(&program));
    let printed = String::from_utf8_lossy(&plain.stdout).into_owned();
    let complaints = String::from_utf8_lossy(&plain.stderr).into_owned();
    assert!(plain.status.success(), "{name}: {}\n{printed}{complaints}", plain.status);
    assert_eq!(complaints, "", "the library never prints");

    if let Some(watched) = watched(&program, &[]) {
        assert_eq!(watched, printed, "{name} under valgrind");
    }
    printed
}

#[test]
fn two_squares_in_thirty_lines() {
    let source = fs::read_to_string(root().join("hosts/c/two_squares.c")).expect("the smallest host");
    assert!(source.lines().count() <= 30);
    let printed = output("two_squares.c", Link::Shared);
    let mut lines = printed.lines();
    assert_eq!(lines.next(), Some("overlap 0.008"));
    let forces: Vec<[f64; 2]> = lines
        .map(|line| {
            let numbers: Vec<f64> =
                line.split_whitespace().skip(2).map(|word| word.parse().expect("a number")).collect();
            [numbers[0], numbers[1]]
        })
        .collect();
    assert_eq!(forces.len(), 8);
    // k times the depth times the height of the overlap, less at its corners, over 0.01 of 0.8.
    let sum = |nodes: &[[f64; 2]], axis: usize| nodes.iter().map(|force| force[axis]).sum::<f64>();
    assert!((sum(&forces[..4], 0) + 800.0).abs() < 10.0);
    assert!((sum(&forces[4..], 0) - 800.0).abs() < 10.0);
    assert!(sum(&forces, 1).abs() < 0.05);
}

#[test]
fn approach_of_a_tetrahedron_in_cpp() {
    let printed = output("approach.cpp", Link::Shared);
    assert_eq!(printed.lines().count(), 5);
    assert!(printed.starts_with("tip at  1.05  volume 0.000000  area 0.0000  force     0.00\n"));
}

/// A block that only its floor holds comes to rest.
#[test]
fn equilibrium_of_a_loose_block_in_c() {
    let printed = output("equilibrium.c", Link::Shared);
    assert!(printed.ends_with("the floor bears 4.000000000 of 4\n"), "{printed}");
    assert!(printed.contains("free: body 0 along ("), "{printed}");
}

/// Two blocks on a floor, whose host has a matrix and no solver: gaps are closed, and each is borne by what is below.
#[test]
fn equilibrium_of_loose_blocks_in_cpp() {
    let printed = output("equilibrium.cpp", Link::Shared);
    let end = " linear solves; the floor bears 250.000000 of 250, the upper block is borne by 90.000000 of 90\n";
    let solves = printed.strip_suffix(end).and_then(|before| before.lines().last());
    assert!(solves.and_then(|count| count.parse::<u32>().ok()).is_some_and(|count| count <= 10), "{printed}");
}

/// t = k δ + c δ³ on a side of length 1, by hand.
#[test]
fn a_law_of_the_host_in_c() {
    let printed = output("own_law.c", Link::Shared);
    let (checked, carried) = printed.split_once("opening").expect("steps");
    assert!(checked.lines().count() == 3 && !checked.contains("WRONG"), "{checked}");
    assert_eq!(
        carried,
        " 0.03  force 4.080000  energy 0.053100  largest opening 0.03\n\
         opening 0.06  force 14.640000  energy 0.309600  largest opening 0.06\n\
         opening 0.02  force 2.320000  energy 0.021600  largest opening 0.06\n"
    );
}

/// min((0.25 + 0.25 exp(−v/2)) p, 8) on a side of length 1 under the pressure 64 d, by hand; less the elastic slip at the end.
#[test]
fn a_law_of_friction_of_the_host_in_c() {
    let printed = output("friction_law.c", Link::Shared);
    let lines: Vec<&str> = printed.lines().collect();
    let [answers, derivatives, steps @ ..] = &lines[..] else { panic!("{printed}") };
    assert!(
        answers.starts_with("answers: ") && derivatives.starts_with("derivatives: they match the limit"),
        "{printed}"
    );
    assert_eq!(steps.len(), 3, "{printed}");
    let limit = |speed: f64, pressure: f64| ((0.25 + 0.25 * (-speed / 2.0).exp()) * pressure).min(8.0);
    let mut way = 0.0;
    for (line, (speed, depth)) in steps.iter().zip([(1.0, 0.25), (4.0, 0.25), (4.0, 0.5)]) {
        way += 0.5 * speed;
        let (pressure, friction) = (64.0 * depth, limit(speed, 64.0 * depth));
        let slid = way - friction / 64.0;
        assert_eq!(*line, format!("speed {speed:.0}  normal {pressure:.6}  friction {friction:.6}  slid {slid:.6}"));
    }
}

#[test]
fn arrays_of_cpp_hosts_in_any_container() {
    assert_eq!(output("arrays.cpp", Link::Shared), "0 failures\n");
}

#[test]
fn callbacks_that_throw_in_cpp() {
    assert_eq!(output("callbacks.cpp", Link::Shared), "0 failures\n");
}

#[test]
fn every_function_from_cpp() {
    assert_eq!(output("everything.cpp", Link::Static), "0 failures\n");
}

#[test]
fn obstacles_by_shape_and_by_callback() {
    assert_eq!(output("obstacles.c", Link::Shared).lines().count(), 2);
}

#[test]
fn pressure_at_nodes_and_points() {
    let printed = output("fields.c", Link::Shared);
    // k times the depth, on the left side of the second square; the sums are the resultant.
    assert!(
        printed.contains("node 4  pressure 1000.00  gap -0.1000  area 0.4000  normal (-1.00, 0.00)\n"),
        "{printed}"
    );
    assert!(printed.ends_with("force on the second square: 800.00, from its nodes 800.00, from the points 800.00\n"));
}

#[test]
fn points_of_second_order_brought_to_nodes() {
    let printed = output("second_order.c", Link::Shared);
    // 1000 on 0.8 of an edge, by the integrals of its shape functions.
    assert!(printed.starts_with("nodes 9, 16, 12 bear 133.333 533.333 133.333\n"), "{printed}");
    assert!(printed.ends_with("\n0 failures\n"), "{printed}");
}

#[test]
fn newton_with_the_contact_tangent() {
    let printed = output("newton.c", Link::Shared);
    // Linear where contact is closed: one step, and one to see that it was enough.
    assert!(printed.lines().count() <= 4, "{printed}");
}

#[test]
fn contact_step_with_condensed_springs() {
    let printed = output("contact_step.c", Link::Shared);
    assert!(printed.starts_with("state 0  u 0.100699301 0.100699301, expected 0.100699301\npenetration "), "{printed}");
    assert!(printed.ends_with("\nwrong 0\n"), "{printed}");
}

#[test]
fn springs_condensed_by_the_library() {
    let printed = output("condensation.c", Link::Shared);
    let expected = "S 0.5 0 0 0.5  u 0.100699301, expected 0.100699301, between 0.050349650\nwrong 0\n";
    assert_eq!(printed, expected);
}

#[test]
fn rows_of_the_tangent() {
    assert_eq!(output("tangent_rows.c", Link::Shared), "0 failures\n");
}

#[test]
fn floating_point_traps_stay_silent() {
    // Valgrind knows no traps, and would take minutes.
    let printed = succeed(&mut Command::new(compile("traps.c", &scratch("traps"), Link::Shared)));
    assert_eq!(printed, "0 failures\n");
}

#[test]
fn ways_that_must_agree_do() {
    assert!(output("agreement.c", Link::Shared).ends_with("\n0 failures\n"));
}

#[test]
fn steps_with_friction_kept_and_in_one_call() {
    assert!(output("friction.c", Link::Shared).ends_with("\n0 failures\n"));
}

#[test]
fn bad_input_is_refused_by_the_shared_library() {
    assert!(output("bad_input.c", Link::Shared).ends_with("\n0 failures\n"));
}

#[test]
fn bad_input_is_refused_by_the_static_library() {
    assert!(output("bad_input.c", Link::Static).ends_with("\n0 failures\n"));
}

/// Ten thousand contexts with every kind of call take no more memory than a thousand; a hundred are clean under valgrind.
#[test]
fn many_calls_take_no_more_memory() {
    let program = compile("many_calls.c", &scratch("many_calls"), Link::Shared);
    let rounds = if is_sanitized() { "1000" } else { "10000" };
    // Freed blocks that glibc keeps at hand count for held ones, if it keeps any.
    let counted = ("GLIBC_TUNABLES", "glibc.malloc.tcache_count=0:glibc.malloc.mxfast=0");
    let printed = succeed(Command::new(&program).arg(rounds).env(counted.0, counted.1));
    assert!(printed.ends_with("\n0 failures\n"), "{printed}");
    assert!(is_sanitized() || printed.starts_with("10000 rounds: no more held, no more taken\n"), "{printed}");
    if let Some(watched) = watched(&program, &["100"]) {
        assert!(watched.ends_with("\n0 failures\n"), "{watched}");
    }
}

/// The header alone, in every dialect that hosts use, without a warning.
#[test]
fn the_header_is_clean() {
    let header = root().join("include/fmc_contact.h");
    let strict = ["-pedantic", "-Wall", "-Wextra", "-Wstrict-prototypes", "-Werror", "-fsyntax-only"];
    for dialect in ["-std=c99", "-std=c11", "-std=c17"] {
        succeed(compiler("CC", "cc").arg(dialect).args(strict).args(["-x", "c"]).arg(&header));
    }
    let strict = ["-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"];
    for dialect in ["-std=c++11", "-std=c++17", "-std=c++20"] {
        succeed(compiler("CXX", "c++").arg(dialect).args(strict).args(["-x", "c++"]).arg(&header));
    }
}

/// The C++ headers, each alone, with every warning that hosts turn on.
#[test]
fn the_cpp_headers_are_clean() {
    let strict = ["-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wsign-conversion", "-Wshadow", "-Wold-style-cast"];
    for header in cpp_headers() {
        for dialect in ["-std=c++17", "-std=c++20"] {
            let mut check = compiler("CXX", "c++");
            check.args([dialect, "-Werror", "-fsyntax-only"]).args(strict);
            // As an include, since a header that is compiled as a program warns of its own guard.
            succeed(check.arg("-include").arg(&header).args(["-x", "c++", "/dev/null"]));
        }
    }
}

fn cpp_headers() -> Vec<PathBuf> {
    let parts = fs::read_dir(root().join("include/fmc_contact")).expect("the parts of the header");
    let parts = parts.map(|entry| entry.expect("an entry").path());
    std::iter::once(root().join("include/fmc_contact.hpp")).chain(parts).collect()
}

/// A function of the C interface that the C++ headers leave out is one that their users look for in vain.
#[test]
fn cpp_reaches_every_function() {
    let code: String = cpp_headers().iter().map(|file| fs::read_to_string(file).expect("a header")).collect();
    let words: BTreeSet<&str> = code
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"))
        .flat_map(|line| line.split(|c: char| !(c.is_alphanumeric() || c == '_')))
        .collect();
    let missing: Vec<String> = declared().into_iter().filter(|name| !words.contains(name.as_str())).collect();
    assert!(missing.is_empty(), "not in the C++ headers: {missing:?}");
}
