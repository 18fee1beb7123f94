//! What tables and files say of a step.

use crate::scene::{solved, solved_text};
use fmc_deck::{Analysis, Deck, SolveOptions, step_table};
use std::ops::ControlFlow;

/// The file of the page without friction: two squares, one element each, the upper pressed by 10.
fn squares() -> String {
    let page = include_str!("../../../../docs/solve.md");
    let shown = page.split("```text\n").find(|block| block.starts_with("*NODE")).unwrap().split("```").next().unwrap();
    shown.replace("*FRICTION\n0.2\n", "")
}

/// Bodies one element thick: their far nodes belong to the sides, which touch nothing, and have no pressure.
#[test]
fn only_nodes_in_contact_have_pressure() {
    for friction in ["", "*FRICTION\n0.2\n"] {
        let text = squares().replace("*CONTACT PAIR", &format!("{friction}*CONTACT PAIR"));
        let outcome = solved_text::<2>("sides", &text);
        for (place, pressure) in outcome.contact {
            let expected = if place[1] == 1.0 { 10.0 } else { 0.0 };
            assert!((pressure - expected).abs() <= 0.03 * expected, "{place:?}: {pressure}");
        }
    }
}

/// Pressures are those of the normal force: where a block slides with μ = 0.25, they add up to it, and not to 1 + μ² of it.
#[test]
fn friction_is_no_pressure() {
    let outcome = solved::<2>("friction.inp", SolveOptions::default());
    let force = outcome.steps[1].pairs[0].force[1].abs();
    // Nodes of the dragged block, which comes second.
    let start = outcome.contact.len() / 2;
    let mut row: Vec<([f64; 2], f64)> = outcome.contact[start..].iter().copied().filter(|(_, p)| *p > 0.0).collect();
    row.retain(|(place, _)| place[1] == row_height(&outcome.contact[start..]));
    row.sort_by(|(p, _), (q, _)| p[0].total_cmp(&q[0]));
    let sum: f64 = row.windows(2).map(|w| 0.5 * (w[1].0[0] - w[0].0[0]) * (w[0].1 + w[1].1)).sum();
    assert!((sum / force - 1.0).abs() < 0.02, "{sum} {force}");
}

fn row_height(nodes: &[([f64; 2], f64)]) -> f64 {
    nodes.iter().filter(|(_, pressure)| *pressure > 0.0).map(|(place, _)| place[1]).fold(f64::INFINITY, f64::min)
}

/// A step without loads has a residual against the loads before it.
#[test]
fn residuals_are_told_against_the_largest_forces() {
    let text = squares().replace("10.\n*END STEP", "10.\n*END STEP\n*STEP\n*STATIC\n*DLOAD\nUPPER, P3, 0.\n*END STEP");
    let outcome = solved_text::<2>("unloaded", &text);
    let last = &outcome.steps[1];
    assert!(last.load[1].abs() < 1e-12 && last.largest_force > 1.0, "{last:?}");
    assert!(last.residual < 1e-8 * last.largest_force, "{last:?}");
    let table = step_table(last);
    assert!(table.contains("of the largest forces so far"), "{table}");
    // Words of a programming interface are no help in a file, and bodies have names.
    assert!(!table.contains("body 1 along") && table.contains("free: 'UPPER'"), "{table}");
}

/// A step without any force has no residual by forces.
#[test]
fn a_step_without_forces_says_so() {
    let outcome = solved_text::<2>("idle", &squares().replace("*DLOAD\nUPPER, P3, 10.\n", ""));
    assert!(step_table(&outcome.steps[0]).contains("no forces so far"), "{}", step_table(&outcome.steps[0]));
}

/// The reach of a tie that has no POSITION TOLERANCE, in the length of the file, and what it ties.
#[test]
fn ties_tell_their_reach_and_what_is_tied() {
    let text = std::fs::read_to_string(crate::scene::path("tied.inp")).unwrap();
    let line = text.lines().find(|line| line.starts_with("*TIE")).unwrap();
    let text = text.replace(line, "*TIE, NAME=T");
    let outcome = solved_text::<3>("reach-of-none", &text);
    let tie = &outcome.steps[0].ties[0];
    assert!(tie.reach > 0.0 && tie.facets > 0 && tie.nodes > 0 && tie.gap < 1e-9, "{tie:?}");
    let table = step_table(&outcome.steps[0]);
    assert!(table.contains(&format!("tied within a reach of {:.6e}: {} facets", tie.reach, tie.facets)), "{table}");
    // Ties are not contact.
    assert!(outcome.contact.iter().all(|(_, pressure)| *pressure == 0.0));
    let given = text.replace("*TIE, NAME=T", "*TIE, NAME=T, POSITION TOLERANCE=0.125");
    assert_eq!(solved_text::<3>("reach", &given).steps[0].ties[0].reach, 0.125);
}

/// A tie that ties nothing is named by its line, with the words of the file.
#[test]
fn a_tie_across_a_gap_is_refused_by_its_line() {
    let text = std::fs::read_to_string(crate::scene::path("tied.inp")).unwrap();
    let line = text.lines().find(|line| line.starts_with("*TIE")).unwrap();
    let text = text.replace(line, "*TIE, NAME=T, POSITION TOLERANCE=1e-9");
    // The upper block, with labels from 101, 0.01 away.
    let up = |row: &str| match row.split(',').map(str::trim).collect::<Vec<_>>()[..] {
        [label, x, y, z] if label.len() == 3 && z.parse::<f64>().is_ok_and(|z| (1.0..=2.0).contains(&z)) => {
            format!("{label}, {x}, {y}, {}", z.parse::<f64>().unwrap() + 0.01)
        }
        _ => row.to_owned(),
    };
    let text: String = text.lines().map(|row| up(row) + "\n").collect();
    let file = std::env::temp_dir().join(format!("fmc-deck-untied-{}.inp", std::process::id()));
    std::fs::write(&file, &text).unwrap();
    let deck = Deck::read(&file).unwrap();
    let analysis = Analysis::<3>::new(&deck, SolveOptions::default()).unwrap();
    let error = analysis.solve(&mut |_, _| ControlFlow::Continue(()), &mut |_, _| Ok(())).unwrap_err().to_string();
    let line = text.lines().position(|line| line.starts_with("*TIE")).unwrap() + 2;
    assert!(error.contains(&format!(".inp:{line}: '")) && error.contains("POSITION TOLERANCE ties them"), "{error}");
    std::fs::remove_file(file).unwrap();
}

/// Nodes that are held across x = 0 in all steps make it a plane of symmetry: the pressure does not fall off there, as it does at the free
/// side x = 1. Where a step releases them, it falls off at both.
#[test]
fn planes_of_symmetry_are_found() {
    let text = std::fs::read_to_string(crate::scene::path("patch.inp")).unwrap();
    let off = |text: &str, x: f64| {
        let outcome = solved_text::<2>("symmetry", text);
        let mut at = outcome.contact.iter().filter(|(place, _)| *place == [x, 1.0]);
        // The corner of the upper block comes last.
        at.next_back().map(|(_, pressure)| (pressure - 10.0).abs()).unwrap()
    };
    let released = text.clone() + "*STEP\n*STATIC\n*BOUNDARY, OP=NEW\nBOTTOM, 2, 2\n1, 1\n101, 1\n*END STEP\n";
    let found = [off(&text, 0.0), off(&text, 1.0), off(&released, 0.0), off(&released, 1.0)];
    println!("{found:?}");
    assert!(found[0] < 0.5 * found[1] && found[2] > 0.7 * found[3], "{found:?}");
}

/// A tie that pulls has a force by area, and no pressure; without supports its bodies are not driven off from one another.
#[test]
fn ties_that_pull_say_so() {
    let tied = squares()
        .replace("*CONTACT PAIR, INTERACTION=RUB\n", "*TIE, NAME=T\n")
        .replace("UPPER, P3, 10.", "UPPER, P3, -10.");
    let outcome = solved_text::<2>("pulled", &tied);
    let table = step_table(&outcome.steps[0]);
    // The residual of 1e-9 is below the digits.
    assert!(
        table.contains("tied, area 1.000000e0, force by area 1.000000e1") && !table.contains("pressure"),
        "{table}"
    );
    let loose = tied.replace("1, 1, 2\n2, 1, 2\n", "1, 1\n2, 1\n");
    assert_ne!(loose, tied);
    let file = std::env::temp_dir().join(format!("fmc-deck-loose-{}.inp", std::process::id()));
    std::fs::write(&file, loose).unwrap();
    let deck = Deck::read(&file).unwrap();
    std::fs::remove_file(file).unwrap();
    let analysis = Analysis::<2>::new(&deck, SolveOptions::default()).unwrap();
    let ended = analysis.solve(&mut |_, _| ControlFlow::Continue(()), &mut |_, _| Ok(())).unwrap();
    let said = match ended {
        fmc_deck::Solved::Failed(1, error) => error.to_string(),
        other => format!("{other:?}"),
    };
    assert!(!said.contains("come to rest") && said.contains("is not supported"), "{said}");
}
