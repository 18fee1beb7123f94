//! Structs can grow without a new number of the interface: what docs/abi.md says of them.

use super::declarations::{Declarations, Struct};
use super::program::root;
use std::fs;

/// Structs that are what they are for good: views of arrays, entries of rows that hosts lay out themselves, and a pose.
const FROZEN: [&str; 8] = [
    "fmc_coords",
    "fmc_forces",
    "fmc_cell_block",
    "fmc_facet_block",
    "fmc_pose",
    "fmc_part",
    "fmc_contact_side",
    "fmc_carried_slip",
];

fn declared() -> Declarations {
    Declarations::of(&fs::read_to_string(root().join("include/fmc_contact.h")).expect("the header"))
}

#[test]
fn what_may_grow_begins_with_its_size_and_ends_with_room() {
    let grows = |one: &Struct| {
        let (first, last) = (one.fields.first().expect("a field"), one.fields.last().expect("a field"));
        first.name == "struct_size" && last.name == "reserved" && last.length >= Some(3)
    };
    for one in &declared().structs {
        assert_eq!(grows(one), !FROZEN.contains(&one.name.as_str()), "{}", one.name);
    }
}

/// The page names those that are frozen, and no others.
#[test]
fn the_page_says_what_is_frozen() {
    let page = fs::read_to_string(root().join("docs/abi.md")).expect("the page");
    let row = page.lines().find(|line| line.starts_with("| structs that are frozen")).expect("a row");
    let named: Vec<&str> = row.split('`').filter(|text| text.starts_with("fmc_")).collect();
    assert_eq!(named, FROZEN);
}

/// One that the host fills has an `_init`; of the others the library writes the size.
#[test]
fn every_struct_that_may_grow_gets_its_size_from_the_library() {
    let (header, declared) =
        (fs::read_to_string(root().join("include/fmc_contact.h")).expect("the header"), declared());
    for one in declared.structs.iter().filter(|one| !FROZEN.contains(&one.name.as_str())) {
        let init = format!("{}_init", one.name);
        let has_init = declared.functions.iter().any(|function| function.returns.name == init);
        let code =
            header.split(&format!("}} {};", one.name)).next().and_then(|code| code.rsplit("typedef struct {").next());
        let comment = code.expect("its fields").lines().find(|line| line.contains("//")).expect("a comment").trim();
        let expected = match has_init {
            true => format!("// Set by `{init}`, so that the library recognises an uninitialised struct."),
            false => "// Size of this struct, as the library wrote it.".into(),
        };
        assert_eq!(comment, expected, "{}", one.name);
    }
}

/// What lies between fields is set by nobody, and could not become a field.
#[test]
fn no_struct_has_a_hole() {
    let record = fs::read_to_string(root().join("tests/c_abi/interface.txt")).expect("the record");
    let (mut name, mut size, mut end) = ("", 0, 0);
    for line in record.lines() {
        if let Some(rest) = line.strip_prefix("struct ") {
            assert_eq!(end, size, "{name} ends before its size");
            let (of, bytes) = rest.split_once(": ").expect("a size");
            (name, size, end) = (of, bytes.split(' ').next().unwrap().parse().expect("a number"), 0);
        } else if !name.is_empty() && line.starts_with("  ") {
            let mut words = line.split_whitespace().map(|word| word.parse::<usize>());
            let (offset, bytes) = (words.next().unwrap().unwrap(), words.next().unwrap().unwrap());
            assert_eq!(offset, end, "{name} has a hole: {line}");
            end = offset + bytes;
        }
    }
    assert!(end == size && size > 0);
}
