//! The library exports what the header declares, under the name that programs will ask for.

use super::program::{built, root, succeed};
use std::collections::BTreeSet;
use std::fs;
use std::process::Command;

/// Names that stand before a parenthesis outside comments.
pub(crate) fn declared() -> BTreeSet<String> {
    let header = fs::read_to_string(root().join("include/fmc_contact.h")).expect("the header");
    header
        .lines()
        .filter(|line| !line.trim_start().starts_with(['/', '*']))
        .filter_map(|line| line.split_once('(')?.0.rsplit([' ', '*']).next())
        .filter(|name| name.starts_with("fmc_"))
        .map(str::to_owned)
        .collect()
}

#[test]
fn exactly_the_declared_functions_are_exported() {
    let symbols = succeed(Command::new("nm").args(["-D", "--defined-only"]).arg(built().join("libfmc_contact.so")));
    let exported: BTreeSet<String> =
        symbols.lines().filter_map(|line| line.split_whitespace().last()).map(str::to_owned).collect();
    assert_eq!(exported, declared());
    assert!(exported.len() > 30);
}

#[test]
fn every_name_carries_the_prefix() {
    let header = fs::read_to_string(root().join("include/fmc_contact.h")).expect("the header");
    let mut names = 0;
    for line in header.lines().map(str::trim).filter(|line| !line.starts_with(['/', '*'])) {
        let constant = line.strip_prefix("#define ").or(line.split_once(" = ").map(|(name, _)| name));
        let name = constant.or(line.strip_prefix("} ")).and_then(|rest| rest.split([' ', ';']).next());
        if let Some(name) = name.filter(|name| !name.is_empty()) {
            assert!(name.starts_with(if constant.is_some() { "FMC_" } else { "fmc_" }), "{line}");
            names += 1;
        }
    }
    assert!(names > 50);
}

#[test]
fn the_shared_library_is_named_for_its_minor_version() {
    let dynamic = succeed(Command::new("readelf").arg("-d").arg(built().join("libfmc_contact.so")));
    let name = concat!("libfmc_contact.so.", env!("CARGO_PKG_VERSION_MAJOR"), ".", env!("CARGO_PKG_VERSION_MINOR"));
    assert!(dynamic.contains(&format!("soname: [{name}]")), "{dynamic}");
}
