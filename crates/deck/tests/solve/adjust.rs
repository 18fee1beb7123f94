//! Gaps and overlaps of the mesh that `ADJUST` removes, and surfaces that an interaction ties.

use crate::scene::{largest_off, path, solved_text};

/// The blocks of `patch.inp` with the upper one, from y = 1 on, moved up.
fn moved(by: f64) -> String {
    let text = std::fs::read_to_string(path("patch.inp")).unwrap();
    let (before, rest) = text.split_once("*NODE, NSET=NUPPER\n").unwrap();
    let (nodes, after) = rest.split_once("*ELEMENT").unwrap();
    let up = |line: &str| {
        let mut fields: Vec<String> = line.split(',').map(str::to_owned).collect();
        fields[2] = (fields[2].trim().parse::<f64>().unwrap() + by).to_string();
        fields.join(",")
    };
    let nodes: String = nodes.lines().map(|line| up(line) + "\n").collect();
    format!("{before}*NODE, NSET=NUPPER\n{nodes}*ELEMENT{after}")
}

/// A gap of 0.01 within ADJUST is closed without a way down; one that lies beyond it stays.
#[test]
fn a_gap_within_adjust_is_closed() {
    let text = moved(0.01).replace("*CONTACT PAIR,", "*CONTACT PAIR, ADJUST=0.02,");
    let outcome = solved_text::<2>("closed", &text);
    let down = outcome.displacement.iter().map(|u| u[1]).fold(0.0, f64::min);
    assert!((down + 0.0182).abs() < 2e-4, "{down}");
    let adjustment = outcome.steps[0].adjustment.unwrap();
    assert!(adjustment.count > 0 && (adjustment.closed - 0.01).abs() < 1e-6, "{adjustment:?}");
    let outcome = solved_text::<2>("beyond", &moved(0.01).replace("*CONTACT PAIR,", "*CONTACT PAIR, ADJUST=0.005,"));
    let down = outcome.displacement.iter().map(|u| u[1]).fold(0.0, f64::min);
    assert!((down + 0.0182 + 0.01).abs() < 2e-4, "{down}");
}

/// An overlap that no load explains presses nothing after ADJUST=0.
#[test]
fn an_overlap_is_removed_without_strain() {
    let text = moved(-0.002).replace("UTOP, P3, 10.", "UTOP, P3, 0.");
    let held = text.replace("*STEP", "*NSET, NSET=NTOP, GENERATE\n109, 112\n*BOUNDARY\nNTOP, 2, 2\n*STEP");
    let force = |text: &str| {
        let outcome = solved_text::<2>("overlap", text);
        outcome.steps[0].pairs.first().map_or(0.0, |pair| pair.force[1].abs())
    };
    // Two blocks of height 1 that are pressed by 0.002: E/(1 − ν²) 0.001.
    let pressed = force(&held);
    assert!((pressed / (1000.0 / 0.91 * 0.001) - 1.0).abs() < 0.05, "{pressed}");
    let left = force(&held.replace("*CONTACT PAIR,", "*CONTACT PAIR, ADJUST=0.,"));
    assert!(left < 1e-3 * pressed, "{left}");
}

/// Surfaces of an interaction that is TIED stay together when they are pulled.
#[test]
fn a_tied_interaction_holds_what_pulls() {
    let text = std::fs::read_to_string(path("patch.inp")).unwrap();
    let tied = "NAME=PRESS\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TIED\n1e6";
    let text = text.replacen("NAME=PRESS", tied, 1).replace("UTOP, P3, 10.", "UTOP, P3, -10.");
    let outcome = solved_text::<2>("tied", &text);
    let off = largest_off(&outcome.stresses, [0.0, 10.0, 3.0, 0.0, 0.0, 0.0]);
    assert!(off < 1e-8, "{off:.2e}");
    assert!(outcome.steps[0].pairs[0].is_tied && outcome.steps[0].ties.len() == 1);
}
