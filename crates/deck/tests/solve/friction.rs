//! A block dragged along another.

use crate::scene::solved;
use fmc_deck::{Analysis, Deck, SolveOptions, Solved};
use std::ops::ControlFlow;

/// Where all of a face slides, the friction is μ times the force that presses. The block below is a million times as stiff, so that the
/// face stays flat. What is left is the pressure on the side walls as far as they are sunk, a part of the penetration of 1e-3.
#[test]
fn a_dragged_block_slides_by_its_coefficient() {
    let outcome = solved::<2>("friction.inp", SolveOptions::default());
    let [pressed, dragged] = &outcome.steps[..] else { panic!("two steps") };
    let [along, across, _] = dragged.pairs[0].force;
    assert!(across > 1.0 && (along / across + 0.25).abs() < 2e-4, "{along} {across}");
    // It is pressed in the middle of a face that is symmetric: nothing slides to one side.
    assert!(pressed.pairs[0].force[0].abs() < 1e-4 * pressed.pairs[0].force[1], "{:?}", pressed.pairs[0]);
    // The reaction of the set that is asked for holds against both.
    let (name, reaction) = &dragged.sets[0];
    assert_eq!(name, "TOP");
    assert!((reaction[0] + along).abs() < 1e-8 && (reaction[1] + across).abs() < 1e-8, "{reaction:?}");
}

/// A square pressed by 10 with μ = 0.2 and pushed along by 5 slides on, and off: it is told that this is more than friction holds, and not that it has left the other.
#[test]
fn a_block_that_slides_on_is_not_told_to_be_apart() {
    let page = include_str!("../../../../docs/solve.md");
    let shown = page.split("```text\n").find(|block| block.starts_with("*NODE")).unwrap().split("```").next().unwrap();
    let start = &shown[..shown.find("*BOUNDARY").unwrap()];
    let text = format!(
        "{start}*NODE\n9, 0.5, 5.\n*RIGID BODY, ELSET=UPPER, REF NODE=9\n*BOUNDARY\n1, 1, 2\n2, 1, 2\n9, 6\n\
         *STEP\n*STATIC\n*BOUNDARY\n9, 1\n*CLOAD\n9, 2, -10.\n*END STEP\n\
         *STEP\n*STATIC\n*BOUNDARY, OP=NEW\n1, 1, 2\n2, 1, 2\n9, 6\n*CLOAD\n9, 1, 5.\n*END STEP\n"
    );
    let file = std::env::temp_dir().join(format!("fmc-deck-slides-{}.inp", std::process::id()));
    std::fs::write(&file, text).unwrap();
    let deck = Deck::read(&file).unwrap();
    std::fs::remove_file(file).unwrap();
    let analysis = Analysis::<2>::new(&deck, SolveOptions::default()).unwrap();
    let ended = analysis.solve(&mut |_, _| ControlFlow::Continue(()), &mut |_, _| Ok(())).unwrap();
    let Solved::Failed(2, error) = ended else { panic!("{ended:?}") };
    let said = error.to_string();
    assert!(said.contains("'UPPER' does not come to rest") && said.contains("along "), "{said}");
    assert!(said.contains("more than friction holds") && !said.contains("separated"), "{said}");
}
