//! The header in the order of use: its head, its headings, and what stands under each.

use super::declarations::Declarations;
use super::header::{SECTIONS, heading};
use super::program::root;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

fn committed() -> String {
    fs::read_to_string(root().join("include/fmc_contact.h")).expect("the header")
}

/// Titles of the headings, each with the functions that are declared under it.
fn under_headings(header: &str) -> Vec<(&str, Vec<String>)> {
    let (head, body) = header.split_once("\n// ---- ").expect("a heading");
    assert!(!head.contains("fmc_status fmc_"), "a function without a heading");
    body.split("\n// ---- ")
        .map(|text| {
            let (line, rest) = text.split_once('\n').expect("more than a heading");
            let declared = Declarations::of(&format!("*/{}", rest.split("\n#ifdef").next().unwrap_or(rest)));
            (
                line.trim_end_matches('-').trim_end(),
                declared.functions.into_iter().map(|one| one.returns.name).collect(),
            )
        })
        .collect()
}

#[test]
fn every_function_stands_under_one_heading() {
    let header = committed();
    let sections = under_headings(&header);
    let titles: Vec<&str> = sections.iter().map(|(title, _)| *title).collect();
    assert_eq!(titles, SECTIONS.map(|(title, _)| title));
    assert!(titles.iter().all(|title| header.matches(&heading(title)).count() == 1));
    let mut places: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (title, functions) in &sections {
        assert!(
            !functions.is_empty() || *title == "Arrays of the host, and its mesh",
            "nothing to call under '{title}'"
        );
        functions.iter().for_each(|name| places.entry(name).or_default().push(title));
    }
    let declared = Declarations::of(&header).functions;
    assert_eq!(places.len(), declared.len());
    assert!(places.values().all(|titles| titles.len() == 1), "{places:?}");
}

/// A source that no section names would be left out of the header.
#[test]
fn every_source_with_a_function_is_in_one_section() {
    let mut sources = Vec::new();
    collect(&root().join("src/capi"), &mut sources);
    let named: Vec<&str> = SECTIONS.iter().flat_map(|(_, sources)| sources.iter().copied()).collect();
    for source in &sources {
        assert_eq!(named.iter().filter(|one| *one == source).count(), 1, "{source}");
    }
    assert!(sources.len() > 30);
}

/// Files below a folder that export a function, by their paths without `.rs`.
fn collect(folder: &Path, sources: &mut Vec<String>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            collect(&path, sources);
        } else if fs::read_to_string(&path).is_ok_and(|code| code.contains("#[unsafe(no_mangle)]")) {
            let inside = path.strip_prefix(root().join("src/capi")).expect("a source").with_extension("");
            sources.push(inside.to_str().expect("a name").replace('\\', "/"));
        }
    }
}

/// The head shows a context's life in ten calls, which follow one another in the header, too.
#[test]
fn the_life_at_the_head_is_in_the_order_of_the_header() {
    let header = committed();
    let head = header.split_once("*/").expect("a head").0;
    let life: Vec<&str> = head
        .lines()
        .filter_map(|line| line.trim_start_matches(" *").trim_start().split_once(". fmc_"))
        .filter(|(number, _)| number.parse::<usize>().is_ok())
        .map(|(_, rest)| rest.split_whitespace().next().expect("a name"))
        .collect();
    assert_eq!(life.len(), 10, "{life:?}");
    let names: Vec<String> = Declarations::of(&header).functions.into_iter().map(|one| one.returns.name).collect();
    let place = |call: &&str| names.iter().position(|name| *name == format!("fmc_{call}")).unwrap_or(usize::MAX);
    let places: Vec<usize> = life.iter().map(place).collect();
    assert!(places.is_sorted() && places[9] < names.len(), "{life:?} are at {places:?}");
}
