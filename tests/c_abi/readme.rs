//! The programs of docs/first-contact.md in C, C++ and Fortran are compiled and run as they stand there; the README's are the same.

use super::program::{built, compiler, root, scratch, succeed};
use std::fs;
use std::process::Command;

/// The program of a language, of at most ten lines.
pub(crate) fn program(language: &str) -> String {
    let page = fs::read_to_string(root().join("docs/first-contact.md")).expect("the page");
    let source = programs(&page, language).next().expect("a program");
    assert!(source.lines().count() <= 10, "first force in ten lines of {language}");
    source.to_owned()
}

/// The programs of a page in one language.
fn programs<'a>(page: &'a str, language: &str) -> impl Iterator<Item = &'a str> {
    let begin = format!("```{language}\n");
    let places: Vec<usize> = page.match_indices(&begin).map(|(place, _)| place + begin.len()).collect();
    places.into_iter().filter_map(|place| page[place..].split("```").next())
}

#[test]
fn the_readme_has_programs_of_that_page() {
    let [readme, page] =
        ["README.md", "docs/first-contact.md"].map(|name| fs::read_to_string(root().join(name)).expect("a page"));
    for (language, count) in [("c", 1), ("python", 2)] {
        let shown: Vec<&str> = programs(&readme, language).collect();
        let is_there = |shown: &&str| programs(&page, language).any(|program| program == *shown);
        assert!(shown.len() == count && shown.iter().all(is_there), "{language}");
    }
}

#[test]
fn the_c_program_prints_the_forces_of_two_squares() {
    expect_forces(&printed("c", compiler("CC", "cc")));
}

#[test]
fn the_cpp_program_prints_the_forces_of_two_squares() {
    expect_forces(&printed("cpp", compiler("CXX", "c++")));
}

/// What the program of a language prints, compiled by what is given.
fn printed(language: &str, mut command: Command) -> String {
    let folder = scratch(&format!("readme-{language}"));
    let (file, squares) = (folder.join("squares").with_extension(language), folder.join("squares"));
    fs::write(&file, program(language)).expect("a writable folder");
    command.args(["-Wall", "-Wextra", "-Werror", "-I"]).arg(root().join("include")).arg("-o").arg(&squares);
    succeed(command.arg(&file).arg(built().join("libfmc_contact.a")).args(["-lpthread", "-ldl", "-lm"]));
    succeed(&mut Command::new(&squares))
}

/// The overlap is 0.01 wide and 0.8 high; k times both pushes the squares apart, less at its corners, over 0.01 of 0.8.
pub(crate) fn expect_forces(printed: &str) {
    let x = |line: &str| line.split_whitespace().nth(2).and_then(|word| word.parse::<f64>().ok()).expect("a force");
    let forces: Vec<f64> = printed.lines().map(x).collect();
    assert_eq!(forces.len(), 8);
    let (left, right): (f64, f64) = (forces[..4].iter().sum(), forces[4..].iter().sum());
    assert!((left + 800.0).abs() < 10.0 && (right - 800.0).abs() < 10.0, "{printed}");
}

#[test]
fn the_fortran_program_prints_the_forces_of_two_squares() {
    let folder = scratch("readme-fortran");
    fs::write(folder.join("squares.f90"), program("fortran")).expect("a writable folder");
    let mut command = compiler("FC", "gfortran");
    command.current_dir(&folder);
    command.args(["fmc_contact_c.f90", "fmc_contact.f90"].map(|name| root().join("bindings/fortran").join(name)));
    command.args(["squares.f90", "-o", "squares"]).arg(built().join("libfmc_contact.a"));
    succeed(command.args(["-lpthread", "-ldl", "-lm"]));
    expect_forces(&succeed(&mut Command::new(folder.join("squares"))));
}
