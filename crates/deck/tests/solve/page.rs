//! The file that `docs/solve.md` shows.

use fmc_deck::{Analysis, Deck, SolveOptions};
use std::fs;
use std::ops::ControlFlow;

/// Two squares of height 1 under a pressure of 10: the pair bears it, and the sides are as free as friction lets them be.
#[test]
fn the_page_shows_a_file_that_is_solved() {
    let page = include_str!("../../../../docs/solve.md");
    let shown = page.split("```text\n").find(|block| block.starts_with("*NODE")).unwrap().split("```").next().unwrap();
    let file = std::env::temp_dir().join(format!("fmc-deck-page-{}.inp", std::process::id()));
    fs::write(&file, shown).unwrap();
    let deck = Deck::read(&file).unwrap();
    let analysis = Analysis::<2>::new(&deck, SolveOptions::default()).unwrap();
    assert!(analysis.notes.is_empty(), "{:?}", analysis.notes);
    let mut steps = Vec::new();
    let reached = &mut |_: &_, step| {
        steps.push(step);
        Ok(())
    };
    analysis.solve(&mut |_, _| ControlFlow::Continue(()), reached).unwrap();
    let step: &fmc_deck::StepResult = &steps[0];
    assert!((step.pairs[0].force[1] - 10.0).abs() < 1e-6 && step.pairs[0].names == ["LOWER", "UPPER"], "{step:?}");
    assert!(step.warnings.is_empty(), "{step:?}");
    fs::remove_file(file).unwrap();
}
