//! The drawing of the house: imports point one way, `unsafe` stays in the C layer, and no file grows past two concepts.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Folders and files of src from the ground up; a file may import from its own room and from those before it. A name
/// stands for all that lies below it and has no line of its own.
const ROOMS: &[&str] = &[
    "error",
    "dimension",
    "geometry",
    "ranks",
    "sparse",
    "sampling",
    "depth_field",
    "configuration",
    "overlap/pair/partner",
    "overlap/pair/surface_point",
    "overlap/pair/warning",
    "overlap/pair/options",
    "overlap/pair/overlap",
    "overlap/pair",
    "overlap/gaps",
    "overlap/sums",
    // The default law, below all lines and patches.
    "overlap/depth",
    "overlap/lines",
    "overlap/normal_lines/patches",
    "overlap/normal_lines/points",
    "overlap/normal_lines",
    "overlap/volume",
    "overlap",
    "contact/tangents",
    "contact/equilibrium/descent",
    "contact/laws",
    "contact/friction",
    "contact/results",
    "contact/explicit",
    "contact/method",
    "contact/partners",
    "contact/mesh",
    "contact/work",
    "contact/history",
    "contact/evaluation",
    "contact/changes",
    "contact/interface",
    "contact",
    "partition",
    "capi/boundary",
    "capi/structs",
    "capi/context",
    "capi/calls",
];

/// The exact estimator and the sampled one, which do not know each other.
const ESTIMATORS: [&[&str]; 2] = [
    &["overlap/depth", "overlap/volume/clipped", "overlap/normal_lines/projected"],
    &["overlap/lines", "overlap/volume/on_lines", "overlap/normal_lines/sampled"],
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

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
    files.sort();
    files
}

/// Path of a module within src, without the ending.
fn module(file: &Path) -> String {
    let inside = file.strip_prefix(root()).expect("a source").with_extension("");
    inside.to_string_lossy().replace('\\', "/")
}

/// All modules that a file imports, as paths within src: what stands behind `crate::` and `super::`, also in grouped
/// imports, as far as it names files.
fn imported(module: &str, text: &str, modules: &BTreeSet<String>) -> BTreeSet<String> {
    let text: String =
        text.split("#[cfg(test)]").next().unwrap_or("").lines().filter(|l| !l.trim_start().starts_with("//")).collect();
    let mut found = BTreeSet::new();
    for (marker, base) in [("crate::", String::new()), ("super::", parent(module))] {
        for (at, _) in text.match_indices(marker) {
            let rest = &text[at + marker.len()..];
            for path in paths(rest) {
                let mut path = if base.is_empty() { path } else { format!("{base}/{path}") };
                while !path.is_empty() && !modules.contains(&path) {
                    path = parent(&path);
                }
                if !path.is_empty() && path != module {
                    found.insert(path);
                }
            }
        }
    }
    found
}

fn parent(module: &str) -> String {
    module.rsplit_once('/').map_or(String::new(), |(folder, _)| folder.to_owned())
}

/// The paths that begin here: one, or those of a group.
fn paths(text: &str) -> Vec<String> {
    let end = text.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':')).unwrap_or(text.len());
    let stem = text[..end].trim_end_matches(':').replace("::", "/");
    let Some(group) = text[end..].strip_prefix('{') else { return vec![stem] };
    let group = &group[..group.find('}').unwrap_or(group.len())];
    group
        .split(',')
        .map(|item| {
            let item = item.trim().replace("::", "/");
            if stem.is_empty() { item } else { format!("{stem}/{item}") }
        })
        .collect()
}

fn room(module: &str) -> Option<usize> {
    let inside = |room: &&&str| module == **room || module.starts_with(&format!("{room}/"));
    let longest = ROOMS.iter().filter(inside).max_by_key(|room| room.len())?;
    ROOMS.iter().position(|room| room == longest)
}

/// Imports of every module.
fn imports() -> BTreeMap<String, BTreeSet<String>> {
    let files = sources(&root());
    let modules: BTreeSet<String> = files.iter().map(|file| module(file)).collect();
    let of = |file: &PathBuf| {
        let text = fs::read_to_string(file).expect("a source");
        (module(file), imported(&module(file), &text, &modules))
    };
    files.iter().map(of).collect()
}

#[test]
fn imports_point_down_the_rooms() {
    let mut seen = 0;
    for (module, imported) in imports() {
        let Some(here) = room(&module) else { continue };
        // The file of a folder holds its explanation and its re-exports.
        let is_folder = root().join(&module).is_dir();
        for other in imported.iter().filter(|other| !(is_folder && other.starts_with(&format!("{module}/")))) {
            let Some(there) = room(other) else { continue };
            seen += 1;
            assert!(there <= here, "{module} imports from {other}, which stands above it");
        }
    }
    assert!(seen > 200, "only {seen} imports were found");
}

#[test]
fn the_two_estimators_do_not_know_each_other() {
    for (module, imported) in imports() {
        for [this, other] in [ESTIMATORS, [ESTIMATORS[1], ESTIMATORS[0]]] {
            let is_of = |module: &str, rooms: &[&str]| rooms.iter().any(|room| module.starts_with(room));
            if is_of(&module, this) {
                assert!(!imported.iter().any(|import| is_of(import, other)), "{module} knows one of {other:?}");
            }
        }
    }
}

#[test]
fn no_imports_run_in_a_circle() {
    let imports = imports();
    let is_folder = |module: &str| root().join(module).is_dir();
    // Folders' own files only pass names on.
    let mut left: BTreeMap<&String, BTreeSet<&String>> = imports
        .iter()
        .filter(|(module, _)| !is_folder(module) && !module.ends_with("/tests"))
        .map(|(module, imported)| (module, imported.iter().filter(|other| !is_folder(other)).collect()))
        .collect();
    loop {
        let done: Vec<&String> =
            left.iter().filter(|(_, on)| on.iter().all(|other| !left.contains_key(other))).map(|(m, _)| *m).collect();
        if done.is_empty() {
            break;
        }
        done.iter().for_each(|module| drop(left.remove(*module)));
    }
    let circle: Vec<String> = left
        .iter()
        .map(|(module, on)| {
            let on: Vec<&str> = on.iter().filter(|other| left.contains_key(*other)).map(|o| o.as_str()).collect();
            format!("{module} -> {}", on.join(", "))
        })
        .collect();
    assert!(circle.is_empty(), "imports run in a circle among:\n{}", circle.join("\n"));
}

#[test]
fn only_the_c_layer_is_unsafe() {
    for folder in
        ["src", "hosts/reference/src", "crates/shapes/src", "crates/mesh-io/src", "benchmarks/src", "tools/fmc/src"]
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
    for file in sources(&root()) {
        let lines = fs::read_to_string(&file).expect("a source").lines().count();
        assert!(lines <= 400, "{} has {lines} lines: two concepts are inside", file.display());
    }
}
