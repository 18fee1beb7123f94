//! As little penetration as is wanted, by contact steps between which surfaces are moved out.

use crate::springs::{SPRING, square, step, step_of};
use fmc_contact::contact::{ContactStep, ContactStepOptions, ContactStepState};

/// The square of [`step`], as it has come to rest with surfaces moved out, and the number of updates.
fn rested(height: f64, push: f64, enough: f64) -> (ContactStep, usize) {
    let (coords, mut contact) = square(height);
    for updates in 0..20 {
        let found = step_of(&contact, &coords, push, &ContactStepOptions::default());
        assert_eq!(found.state, ContactStepState::Converged, "{found:?}");
        let d = &found.displacement;
        let moved = [[d[0], d[1]], [d[2], d[3]], [0.0, d[3]], [0.0, d[1]]];
        let there: Vec<[f64; 2]> = coords.iter().zip(moved).map(|(x, d)| [x[0] + d[0], x[1] + d[1]]).collect();
        let gaps = contact.augment(&there, 0.0, enough).unwrap();
        if gaps.is_enough {
            assert!(gaps.penetration <= enough);
            return (found, updates);
        }
    }
    panic!("a penetration of {enough:e} is not reached");
}

/// A square on springs that a plane stops where it is: without penetration d is the height, whatever k.
#[test]
fn a_plane_stops_a_square() {
    for (height, push) in [(0.1, 20.0), (-0.05, 10.0), (-0.4, 10.0)] {
        for enough in [1e-3, 1e-6, 1e-10] {
            let (found, updates) = rested(height, push, enough);
            assert!((found.displacement[1] + height).abs() <= 1.01 * enough, "{height}: {found:?}");
            assert!(updates <= 8, "{height}, {enough:e}: {updates} updates");
        }
        // What the plane bears: all of the push and of the springs.
        let found = rested(height, push, 1e-10).0;
        let pressed = -(SPRING * found.displacement[1] + push);
        assert!((pressed - (SPRING * height - push)).abs() < 1e-6, "{pressed}");
    }
}

/// Less than the law leaves is not asked for: nothing is moved out, and the answer has the bits of the law's.
#[test]
fn a_law_that_is_stiff_enough_is_left_alone() {
    assert_eq!(rested(0.1, 20.0, 1.0), (step(0.1, 20.0, &ContactStepOptions::default()), 0));
}
