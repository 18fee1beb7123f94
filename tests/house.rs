//! The drawing of the house: imports point one way, `unsafe` stays in the C layer, and no file grows past two concepts.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Folders and files of src from the ground up; a file may import from its own room and from those before it. A name
/// stands for all that lies below it and has no line of its own.
const ROOMS: &[&str] = &[
    "error",
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
    "interfaces",
    "contact/tangents",
    "contact/equilibrium/descent",
    "contact/laws",
    "contact/friction",
    "contact/wear",
    "contact/results",
    "contact/explicit",
    "contact/method",
    "contact/partners",
    "contact/mesh",
    "contact/held",
    "contact/ties",
    "contact/glides",
    "contact/flux",
    "contact/cohesive",
    "contact/governed",
    "contact/work",
    "contact/history",
    "contact/derivatives",
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

/// The crates of the workspace and the fuzz targets, by the folders of their sources.
const CRATES: [&str; 8] = [
    "src",
    "hosts/reference/src",
    "crates/shapes/src",
    "crates/mesh-io/src",
    "crates/deck/src",
    "benchmarks/src",
    "tools/fmc/src",
    "fuzz/src",
];

fn at(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

fn root() -> PathBuf {
    at("src")
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

/// Path of a module within the sources of its crate, without the ending.
fn module(root: &Path, file: &Path) -> String {
    let inside = file.strip_prefix(root).expect("a source").with_extension("");
    inside.to_string_lossy().replace('\\', "/")
}

/// All modules that a file imports, as paths within its crate: what stands behind `crate::` and `super::`, also in grouped
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

/// Imports of every module of a crate.
fn imports(root: &Path) -> BTreeMap<String, BTreeSet<String>> {
    let files = sources(root);
    let modules: BTreeSet<String> = files.iter().map(|file| module(root, file)).collect();
    let of = |file: &PathBuf| {
        let text = fs::read_to_string(file).expect("a source");
        (module(root, file), imported(&module(root, file), &text, &modules))
    };
    files.iter().map(of).collect()
}

#[test]
fn imports_point_down_the_rooms() {
    let mut seen = 0;
    for (module, imported) in imports(&root()) {
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
    for (module, imported) in imports(&root()) {
        for [this, other] in [ESTIMATORS, [ESTIMATORS[1], ESTIMATORS[0]]] {
            let is_of = |module: &str, rooms: &[&str]| rooms.iter().any(|room| module.starts_with(room));
            if is_of(&module, this) {
                assert!(!imported.iter().any(|import| is_of(import, other)), "{module} knows one of {other:?}");
            }
        }
    }
}

/// The modules of a crate that are in a circle of imports or above one, with what they import of the others.
fn circle(root: &Path) -> Vec<String> {
    let imports = imports(root);
    let is_folder = |module: &str| root.join(module).is_dir();
    // Folders' own files only pass names on, and so does that of the crate.
    let only_passes_on = |module: &str| is_folder(module) || module.ends_with("/tests") || module == "lib";
    let mut left: BTreeMap<&String, BTreeSet<&String>> = imports
        .iter()
        .filter(|(module, _)| !only_passes_on(module))
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
    let of = |(module, on): (&&String, &BTreeSet<&String>)| {
        let on: Vec<&str> = on.iter().filter(|other| left.contains_key(*other)).map(|o| o.as_str()).collect();
        format!("{module} -> {}", on.join(", "))
    };
    left.iter().map(of).collect()
}

#[test]
fn no_imports_run_in_a_circle() {
    for folder in CRATES {
        let circle = circle(&at(folder));
        assert!(circle.is_empty(), "imports of {folder} run in a circle among:\n{}", circle.join("\n"));
    }
}

/// The floors of the module in words, from the top down, as `lib.rs` and `ARCHITECTURE.md` draw them.
fn drawn(text: &str) -> Vec<Vec<String>> {
    let line = text.lines().find(|line| line.contains("capi  ->  ")).expect("the drawing of the floors");
    let line = line.trim_start_matches("//!").trim();
    line.split("->").map(|floor| floor.split(',').map(|name| name.trim().to_owned()).collect()).collect()
}

#[test]
fn the_floors_are_drawn_as_they_are() {
    let files = ["src/lib.rs", "ARCHITECTURE.md"];
    let [floors, again] = files.map(|file| drawn(&fs::read_to_string(at(file)).expect("a page")));
    assert_eq!(floors, again, "{} and {} draw other floors", files[0], files[1]);
    let floor_of = |module: &str| {
        let top = module.split('/').next().unwrap_or("");
        floors.iter().position(|names| names.iter().any(|name| name == top))
    };
    for (module, imported) in imports(&root()).iter().filter(|(module, _)| *module != "lib") {
        let here = floor_of(module).unwrap_or_else(|| panic!("{module} is on no floor of the drawing"));
        for other in imported {
            let there = floor_of(other).unwrap_or_else(|| panic!("{other} is on no floor of the drawing"));
            let is_own = module.split('/').next() == other.split('/').next();
            assert!(is_own || here < there, "{module} imports from {other}, which the drawing has beside or above it");
        }
    }
    for name in floors.iter().flatten() {
        assert!(root().join(name).with_extension("rs").exists(), "the drawing has {name}, which is not there");
    }
}

/// A room without a line of its own would never be looked at.
#[test]
fn every_module_is_in_a_room() {
    let is_folder = |module: &str| root().join(module).is_dir();
    for module in imports(&root()).keys().filter(|module| *module != "lib" && !is_folder(module)) {
        assert!(room(module).is_some(), "{module} is in no room");
    }
    for room in ROOMS {
        let is_there = root().join(room).is_dir() || root().join(room).with_extension("rs").exists();
        assert!(is_there, "the room {room} is not there");
    }
}

/// The fuzz targets call the library as C does.
#[test]
fn only_the_c_layer_is_unsafe() {
    for file in CRATES.iter().filter(|folder| **folder != "fuzz/src").flat_map(|folder| sources(&at(folder))) {
        let text = fs::read_to_string(&file).expect("a source");
        let is_unsafe = text.lines().any(|l| {
            let code = l.split("//").next().unwrap_or("");
            code.contains("unsafe ") || code.contains("unsafe{")
        });
        let in_capi = file.starts_with(at("src/capi"));
        assert!(!is_unsafe || in_capi, "{} holds unsafe code", file.display());
    }
}

#[test]
fn public_constants_can_be_macros_of_c() {
    // The build of the Python package lays every public constant into a header as a macro, and cffi reads whole numbers alone.
    for path in sources(&root()) {
        let text = fs::read_to_string(&path).expect("a source");
        let real = text.lines().find(|line| line.trim_start().starts_with("pub const ") && line.contains(": f64 ="));
        assert!(real.is_none(), "{}: {}", path.display(), real.unwrap().trim());
    }
}

/// What takes coordinates does work: other crates would compile all of it again.
#[test]
fn evaluations_are_compiled_in_the_library() {
    for file in sources(&at("src/contact/interface")) {
        let text = fs::read_to_string(&file).expect("a source");
        for (before, function) in text.match_indices("\n    pub fn ").map(|(at, _)| text.split_at(at)) {
            let head = &function[..function.find(" {\n").expect("a body")];
            let is_kept = before.ends_with("#[inline(never)]") || !head.contains("coords: &[[f64; D]]");
            assert!(is_kept, "{}: #[inline(never)] for{}", file.display(), head.replace("\n", " "));
        }
    }
}

#[test]
fn files_hold_one_concept() {
    for file in CRATES.iter().flat_map(|folder| sources(&at(folder))) {
        let text = fs::read_to_string(&file).expect("a source");
        let (lines, is_generated) = (text.lines().count(), text.contains("\n//! Generated from "));
        assert!(lines <= 400 || is_generated, "{} has {lines} lines: two concepts are inside", file.display());
    }
}

/// What does not hold yet says why. `cargo test --test house ignored -- --nocapture` lists it.
#[test]
fn what_is_ignored_says_why() {
    let folders = ["src", "tests", "hosts/reference", "crates", "benchmarks", "tools"];
    for file in folders.iter().flat_map(|folder| sources(&at(folder))) {
        let text = fs::read_to_string(&file).expect("a source");
        let mut lines = text.lines().map(str::trim);
        while let Some(line) = lines.next() {
            let Some(rest) = line.strip_prefix("#[ignore") else { continue };
            let reason = rest.strip_prefix(" = \"").and_then(|rest| rest.strip_suffix("\"]")).unwrap_or("");
            let name = lines.find_map(|line| line.strip_prefix("fn ")).unwrap_or("");
            let name = name.split('(').next().unwrap_or("");
            let file = file.strip_prefix(at("")).unwrap_or(&file).display();
            println!("{file}: {name}: {reason}");
            assert!(reason.split(' ').count() >= 5, "{file}: {name} does not say why it is ignored");
        }
    }
}

/// The crates of the workspace, each with a row in the table of `ARCHITECTURE.md`.
#[test]
fn every_crate_is_in_the_table() {
    let [cargo, page] = ["Cargo.toml", "ARCHITECTURE.md"].map(|file| fs::read_to_string(at(file)).expect("a file"));
    let members = cargo.lines().find(|line| line.starts_with("members = ")).expect("the members");
    for member in members.split('"').skip(1).step_by(2) {
        let (row, sources) = if member == "." { ("src/", "src".into()) } else { (member, format!("{member}/src")) };
        let is_row = |line: &str| line.starts_with('|') && line.contains(&format!("| `{row}` |"));
        assert!(page.lines().any(is_row), "{member} has no row in the table of crates");
        assert!(CRATES.contains(&sources.as_str()), "the house test does not look at {member}");
    }
}

/// What `ARCHITECTURE.md` says that one more law, cell type, … takes: the files by hand, counted, and there.
#[test]
fn recipes_name_files_that_exist() {
    let page = fs::read_to_string(at("ARCHITECTURE.md")).expect("a page");
    let recipes = page.split("\n### One more\n").nth(1).and_then(|rest| rest.split("\n### ").next()).expect("recipes");
    let mut counts = Vec::new();
    for recipe in recipes.split("\n**").skip(1).filter(|recipe| !recipe.starts_with("Others")) {
        let steps = recipe.lines().filter(|line| line.starts_with(|first: char| first.is_ascii_digit()));
        let files: Vec<&str> = steps.map(|step| step.split('`').nth(1).expect("a file first")).collect();
        let missing: Vec<&&str> = files.iter().filter(|file| !at(file).is_file()).collect();
        assert!(missing.is_empty(), "no such files: {missing:?}");
        let said = recipe.split(" files").next().and_then(|before| before.split(['(', ' ']).next_back());
        assert_eq!(said, Some(files.len().to_string().as_str()), "{recipe}");
        counts.push(files.len());
    }
    assert_eq!(
        counts,
        [4, 8, 8, 4, 5, 2],
        "law, cell type, one that is divided, rigid shape, output per node, default"
    );
}
