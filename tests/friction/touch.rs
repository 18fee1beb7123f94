//! Facets that touch in the middle of a step: their slip counts from there.

use crate::scene::Scene;
use crate::{STIFFNESS, begun, in_plane, in_space, laws, raised};
use fmc_contact::{EnergyLaw, Options};

const MU: f64 = 0.3;
const DELTA: f64 = 1e-3;

/// Pressure and traction of the upper block, without its walls, are even: what holds it after it came down from `above`
/// DELTA to DELTA below the surface in `steps` steps, pushed along by `ratio` of its way down; and what it lost.
fn lowered<const D: usize>(scene: &Scene<D>, options: Options, steps: usize, ratio: f64) -> (f64, f64) {
    let above = 1.7 * DELTA;
    let mut contact = begun(scene, options, &raised(scene, above));
    let (mut force, mut lost) = (0.0, 0.0);
    for step in 1..=steps {
        let left = above * (1.0 - step as f64 / steps as f64);
        let mut coords = raised(scene, left);
        scene.nodes_of(1).for_each(|node| coords[node][0] += ratio * (above - left));
        let found = contact.evaluate(&coords).expect("valid coordinates");
        assert!(found.friction.dissipated >= 0.0);
        (force, lost) = (-found.bodies[1].friction[0], lost + found.friction.dissipated);
        contact.commit_step(&coords).expect("a step");
    }
    (force, lost)
}

/// From the touch on both grow at one rate: below the limit the traction is that rate times the pressure, in any number of
/// steps, and above it the limit.
fn in_proportion<const D: usize>(scene: &Scene<D>, area: f64) {
    for options in laws(MU) {
        let pressed = STIFFNESS * DELTA * area;
        for steps in [1, 3, 4, 10] {
            let (force, lost) = lowered(scene, options, steps, 0.5 * MU);
            // Rims bear less, and walls that are sunk in.
            assert!((force / (0.5 * MU * pressed) - 1.0).abs() < 0.02, "{:?} {steps}: {force}", options.law);
            assert!(lost < 5e-3 * MU * pressed * DELTA, "{:?} {steps}: {lost}", options.law);
            let (force, _) = lowered(scene, options, steps, 2.0 * MU);
            assert!((force / (MU * pressed) - 1.0).abs() < 0.02, "{:?} {steps}: {force}", options.law);
        }
        // What slides loses MU k g (2 - 1) MU dg on the way; a step counts its last limit, and so the error is of first order.
        let exact = MU * MU * pressed * 0.5 * DELTA;
        let errors = [10, 20].map(|steps| lowered(scene, options, steps, 2.0 * MU).1 / exact - 1.0);
        assert!(errors[0] > 0.0 && errors[0] < 0.3 && errors[1] < 0.6 * errors[0] + 0.02, "{errors:?}");
    }
}

#[test]
fn a_block_is_lowered_and_pushed() {
    in_plane(DELTA).iter().for_each(|scene| in_proportion(scene, 1.0));
    in_space(DELTA).iter().for_each(|scene| in_proportion(scene, 0.8));
}

/// Under one pressure for the whole pair: k_T by what is left of the way.
#[test]
fn under_one_pressure() {
    let friction = fmc_contact::contact::Friction { stiffness: Some(STIFFNESS), ..laws(MU)[0].friction };
    let options = Options { friction, ..crate::scene::table::exactly(EnergyLaw::volume(10.0)) };
    for scene in in_plane(DELTA) {
        let (force, _) = lowered(&scene, options, 1, 0.5);
        assert!((force / (STIFFNESS * 0.5 * DELTA) - 1.0).abs() < 0.02, "{force}");
    }
}
