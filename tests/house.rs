//! The drawing of the house: imports point one way, `unsafe` stays in the C layer, and no file grows past two concepts.

use std::fs;
use std::path::{Path, PathBuf};

/// Floors from the ground up; a file may import from its own floor and from those before it.
const FLOORS: [&str; 6] = ["error", "geometry", "sampling", "overlap", "contact", "capi"];

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("the sources") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files
}

fn floor_of(file: &Path) -> Option<usize> {
    let inside = file.strip_prefix(concat!(env!("CARGO_MANIFEST_DIR"), "/src")).expect("a source");
    let first = inside.components().next()?.as_os_str().to_str()?.trim_end_matches(".rs").to_owned();
    FLOORS.iter().position(|f| *f == first)
}

/// Names that follow `crate::`, also in grouped imports: `use crate::{Error, geometry::Vector}`.
fn imported(text: &str) -> Vec<String> {
    let mut names = Vec::new();
    for (at, _) in text.match_indices("crate::") {
        let rest = &text[at + "crate::".len()..];
        let end =
            if rest.starts_with('{') { rest.find('}') } else { rest.find([':', ';', ',', ' ', '(', '<', '\n', ')']) };
        let group = &rest[..end.unwrap_or(rest.len())];
        names.extend(group.trim_start_matches('{').split(',').map(|n| n.trim().split(':').next().unwrap_or("").into()));
    }
    names
}

#[test]
fn imports_point_down_the_floors() {
    for file in sources(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/src"))) {
        let Some(floor) = floor_of(&file) else { continue };
        let text = fs::read_to_string(&file).expect("a source");
        for name in imported(&text) {
            if let Some(from) = FLOORS.iter().position(|f| *f == name) {
                assert!(from <= floor, "{} imports from {name}, which stands above it", file.display());
            }
        }
    }
}

#[test]
fn the_two_estimators_do_not_know_each_other() {
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/src/overlap"));
    let knows = |file: &str, other: &str| {
        let text = fs::read_to_string(folder.join(file)).expect("an estimator");
        text.contains(&format!("super::{other}"))
    };
    assert!(!knows("exact.rs", "fibers") && !knows("fibers.rs", "exact"));
}

#[test]
fn only_the_c_layer_is_unsafe() {
    for folder in
        ["src", "crates/shapes/src", "crates/mesh-io/src", "hosts/reference/src", "benchmarks/src", "tools/fmc/src"]
    {
        for file in sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)) {
            let text = fs::read_to_string(&file).expect("a source");
            let is_unsafe = text.lines().any(|l| {
                let code = l.split("//").next().unwrap_or("");
                code.contains("unsafe ") || code.contains("unsafe{")
            });
            let in_capi = file.to_string_lossy().contains("src/capi");
            assert!(!is_unsafe || in_capi, "{} holds unsafe code", file.display());
        }
    }
}

#[test]
fn files_hold_one_concept() {
    for file in sources(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/src"))) {
        let lines = fs::read_to_string(&file).expect("a source").lines().count();
        assert!(lines <= 400, "{} has {lines} lines: two concepts are inside", file.display());
    }
}
