//! The command `fmc study impact`, run as a user runs it.

use std::process::Command;

#[test]
fn impact_study_compares_methods_and_laws() {
    let out = std::env::temp_dir().join(format!("fmc-study-{}", std::process::id()));
    let run = Command::new(env!("CARGO_BIN_EXE_fmc"))
        .args(["study", "impact", "--quick", "--segments", "500", "--spacing", "1e-4", "--out"])
        .arg(&out)
        .output()
        .unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let table = String::from_utf8(run.stdout).unwrap();
    let csv = std::fs::read_to_string(out.join("impact.csv")).unwrap();
    let mut lines = csv.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |line: &[&str], name: &str| -> f64 {
        line[header.iter().position(|column| *column == name).unwrap()].parse().unwrap()
    };
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let names: Vec<String> = rows.iter().map(|row| format!("{} m={}", row[0], row[1])).collect();
    let expected = ["isotropic m=1", "lines m=1", "exact m=1", "isotropic m=2", "lines m=2", "exact m=2"];
    assert_eq!(names, expected);
    assert!(expected.iter().all(|name| table.contains(name)));
    for (row, name) in rows.iter().zip(&names) {
        if name.starts_with("isotropic") {
            // Forces as they come: no reciprocity.
            assert!(column(row, "balance_max") > 1e-3, "{name}");
        } else {
            assert!(column(row, "balance_max") < 1e-12, "{name}");
        }
        // Only a tip is in contact yet, so that the forces do not jump much.
        if name.starts_with("exact") {
            assert!(column(row, "energy_drift").abs() < 1e-4, "{name}");
        }
        assert!(column(row, "impulse") > 5.0, "{name}");
    }
    // The lines' impulse is the exact one.
    for (lines, exact) in [(1, 2), (4, 5)] {
        let [lines, exact] = [lines, exact].map(|row: usize| column(&rows[row], "impulse"));
        assert!((lines / exact - 1.0).abs() < 0.01, "{lines} {exact}");
    }
    assert_eq!(std::fs::read_to_string(out.join("energy.csv")).unwrap().lines().count(), 152);
    assert!(out.join("energy.png").exists() && out.join("energy.svg").exists());
    std::fs::remove_dir_all(out).unwrap();
}
