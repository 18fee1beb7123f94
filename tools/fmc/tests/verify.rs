//! `fmc verify` as a user runs it: the table, the JSON and the pictures.

use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

#[test]
fn every_case_keeps_its_bound_and_is_drawn() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("verify");
    let _ = std::fs::remove_dir_all(&folder);
    let run = Command::new(env!("CARGO_BIN_EXE_fmc")).args(["verify", "--json", "-", "--out"]).arg(&folder).output();
    let run = run.expect("the command runs");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let rows: Vec<Value> = serde_json::from_slice(&run.stdout).expect("standard output is JSON and nothing else");

    let mut combinations = BTreeSet::new();
    for row in &rows {
        let text = |key: &str| row[key].as_str().unwrap_or_else(|| panic!("no text '{key}' in {row}")).to_owned();
        let number = |key: &str| row[key].as_f64().unwrap_or_else(|| panic!("no number '{key}' in {row}"));
        combinations.insert((text("case"), text("estimator"), text("quantity")));
        let _ = (number("computed"), number("reference"), number("crossings"), number("seconds"));
        assert!(number("fibers") <= 30_000.0, "a tenth of the paper's 300 000: {row}");
        // The paper's largest errors, which lines must beat.
        let paper = match (text("case").as_str(), text("quantity").as_str()) {
            ("disc", "value") => 3.6e-4,
            ("disc", "derivative") => 3.22e-3,
            ("sphere", "value") => 3.9e-4,
            ("sphere", "derivative") => 2.25e-3,
            _ => continue,
        };
        assert!(text("estimator") != "lines" || number("relative_error") < paper, "{row}");
    }
    // Seven cases by three estimators, value and derivative.
    assert_eq!(combinations.len(), 7 * 3 * 2, "{combinations:?}");

    for case in rows.iter().filter_map(|row| row["case"].as_str()).collect::<BTreeSet<_>>() {
        for ending in ["png", "svg"] {
            let picture = folder.join(format!("{case}.{ending}"));
            let size = std::fs::metadata(&picture).map_or(0, |m| m.len());
            assert!(size > 5_000, "{} has {size} bytes", picture.display());
        }
    }
}

#[test]
fn one_estimator_may_be_asked_for() {
    let run = Command::new(env!("CARGO_BIN_EXE_fmc"))
        .args(["verify", "--estimator", "exact", "--no-pictures"])
        .output()
        .expect("the command runs");
    let table = String::from_utf8_lossy(&run.stdout);
    assert!(run.status.success() && table.contains("exact") && !table.contains("isotropic"), "{table}");
}
