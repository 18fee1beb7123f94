//! A block dragged along another.

use crate::scene::solved;
use fmc_deck::SolveOptions;

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
