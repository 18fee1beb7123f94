//! `fmc solve`: files, tables and exit status.
#![cfg(feature = "statics")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("fmc-solve-{}-{name}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn deck() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../crates/deck/tests/solve/decks/patch.inp");
    fs::read_to_string(path).unwrap()
}

fn solve(folder: &Path, text: &str) -> Output {
    fs::write(folder.join("model.inp"), text).unwrap();
    Command::new(env!("CARGO_BIN_EXE_fmc")).args(["solve", "model.inp"]).current_dir(folder).output().unwrap()
}

#[test]
fn a_file_leaves_fields_of_every_step_and_a_table() {
    let folder = folder("good");
    let output = solve(&folder, &deck());
    let (table, told) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert_eq!(output.status.code(), Some(0), "{told}");
    for word in ["step 1, time 1", "reactions", "LOWER on UPPER", "contact, area"] {
        assert!(table.contains(word), "{word}: {table}");
    }
    let line = deck().lines().position(|line| line == "*NODE FILE").unwrap() + 1;
    assert!(
        told.contains(&format!("note: model.inp:{line}: *NODE FILE: files and tables do not depend on it")),
        "{told}"
    );
    assert!(told.contains("step 1  load"), "{told}");
    let frd = fs::read_to_string(folder.join("out/model/model.frd")).unwrap();
    assert!(frd.starts_with("    1C") && frd.ends_with(" -3\n 9999\n"));
    let grid = fmc_mesh_io::Mesh::read(&folder.join("out/model/step-1.vtu")).unwrap();
    assert_eq!(grid.cell_count(), 14);
    // The last of 27 nodes is at the top: 2 p (1 − ν²)/E and a penetration below.
    let displacement = fmc_mesh_io::read_floats(&folder.join("out/model/step-1.vtu"), "displacement").unwrap();
    assert!((displacement[3 * 26 + 1] + 0.0182).abs() < 1e-4);
    fs::remove_dir_all(folder).unwrap();
}

/// Steps of a run before would be shown beside those of this one.
#[test]
fn steps_of_a_run_before_are_removed() {
    let folder = folder("again");
    fs::create_dir_all(folder.join("out/model")).unwrap();
    for name in ["step-1.vtu", "step-2.vtu", "step-two.vtu", "notes.txt"] {
        fs::write(folder.join("out/model").join(name), "of before").unwrap();
    }
    assert_eq!(solve(&folder, &deck()).status.code(), Some(0));
    let has = |name: &str| folder.join("out/model").join(name).exists();
    assert!(has("step-1.vtu") && !has("step-2.vtu") && has("step-two.vtu") && has("notes.txt"));
    fs::remove_dir_all(folder).unwrap();
}

/// A pressure by penetration and a wanted penetration say two things of one.
#[test]
fn a_penetration_beside_a_given_slope_is_refused() {
    let folder = folder("slope");
    let interaction = "*SURFACE INTERACTION, NAME=PRESS\n";
    let linear = format!("{interaction}*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1E6\n");
    let text = deck().replace(interaction, &linear);
    fs::write(folder.join("model.inp"), text).unwrap();
    let mut program = Command::new(env!("CARGO_BIN_EXE_fmc"));
    program.args(["solve", "model.inp", "--penetration", "1e-6"]).current_dir(&folder);
    let refused = program.output().unwrap();
    let told = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert_eq!(refused.status.code(), Some(2), "{told}");
    assert!(told.contains("LINEAR defines the pressure by penetration"), "{told}");
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn the_status_tells_a_wrong_file_from_a_body_without_support() {
    let folder = folder("bad");
    let wrong = solve(&folder, &deck().replace("*STATIC", "*DYNAMIC"));
    let told = String::from_utf8_lossy(&wrong.stderr).into_owned();
    assert_eq!(wrong.status.code(), Some(2));
    let line = deck().lines().position(|line| line == "*STATIC").unwrap() + 1;
    assert!(told.starts_with(&format!("error: model.inp:{line}: *DYNAMIC is not known\n")), "{told}");
    // Pulled off, nothing holds the upper block.
    let loose = solve(&folder, &deck().replace("UTOP, P3, 10.", "UTOP, P3, -10."));
    let told = String::from_utf8_lossy(&loose.stderr).into_owned();
    assert_eq!(loose.status.code(), Some(1), "{told}");
    assert!(told.contains("step 1: 'UPPER' does not come to rest"), "{told}");
    assert!(!folder.join("out/model/model.frd").exists());
    fs::remove_dir_all(folder).unwrap();
}

/// Forces that are half out of balance are no equilibrium.
#[test]
fn a_loose_tolerance_is_refused() {
    let folder = folder("tolerance");
    fs::write(folder.join("model.inp"), deck()).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_fmc"));
    let output = command.args(["solve", "model.inp", "--tolerance", "0.5"]).current_dir(&folder).output().unwrap();
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && told.contains("at most 0.01"), "{told}");
    fs::remove_dir_all(folder).unwrap();
}
