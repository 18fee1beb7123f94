//! The README's C program is compiled and run as it stands there.

use super::program::{built, compiler, root, scratch, succeed};
use std::fs;
use std::process::Command;

#[test]
fn the_readme_program_prints_the_forces_of_two_squares() {
    let readme = fs::read_to_string(root().join("README.md")).expect("the README");
    let source = readme.split("```c\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a C program");
    assert!(source.lines().count() <= 10, "first force in ten lines");
    let folder = scratch("readme");
    let (file, program) = (folder.join("squares.c"), folder.join("squares"));
    fs::write(&file, source).expect("a writable folder");
    let mut command = compiler("CC", "cc");
    command.args(["-Wall", "-Wextra", "-Werror", "-I"]).arg(root().join("include")).arg("-o").arg(&program);
    succeed(command.arg(&file).arg(built().join("libfmc_contact.a")).args(["-lpthread", "-ldl", "-lm"]));
    let printed = succeed(&mut Command::new(&program));
    let x = |line: &str| line.split_whitespace().nth(2).and_then(|word| word.parse::<f64>().ok()).expect("a force");
    let forces: Vec<f64> = printed.lines().map(x).collect();
    assert_eq!(forces.len(), 8);
    // The overlap is 0.01 wide and 0.8 high; k times both pushes the squares apart, less at its corners, over 0.01 of 0.8.
    let (left, right): (f64, f64) = (forces[..4].iter().sum(), forces[4..].iter().sum());
    assert!((left + 800.0).abs() < 10.0 && (right - 800.0).abs() < 10.0, "{printed}");
}
