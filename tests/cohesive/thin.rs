//! Thin bodies are glued by the faces that lie on one another alone, whatever the reach.

use crate::scene::Scene;
use crate::thin_bodies::{below_a_shelf, below_a_shelf_in_space, plates, plates_in_space, turned};
use crate::{held, law};
use fmc_contact::contact::Cohesive;

/// Rounding of coordinates and of pieces, whose number is some tens.
fn check<const D: usize>(scene: &Scene<D>, reach: f64, gap: f64) {
    let contact = held(scene, Cohesive { reach, ..law() });
    let found = contact.cohesive([0, 1], &scene.coords).expect("bodies").expect("an interface");
    assert!((found.area - 1.0).abs() < 1e-12 && (found.largest_gap - gap).abs() < 1e-12, "{found:?} within {reach}");
}

#[test]
fn thin_bodies_are_glued_once() {
    for reach in [0.0, 0.15, 10.0] {
        for thicknesses in [&[0.5, 0.03][..], &[0.02, 0.03], &[0.03, 0.01, 0.5]] {
            for gap in [0.0, 0.009, -0.009] {
                check(&turned(plates(thicknesses, gap), 0.3), reach, gap.abs());
                check(&turned(plates_in_space(thicknesses, gap), 0.3), reach, gap.abs());
            }
        }
    }
    for reach in [0.25, 10.0] {
        check(&below_a_shelf(), reach, 0.2);
        check(&below_a_shelf_in_space(), reach, 0.2);
    }
}
