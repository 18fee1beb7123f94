//! Thin bodies are tied by the faces that lie on one another alone, whatever the reach.

use crate::scene::Scene;
use crate::thin_bodies::{below_a_shelf, below_a_shelf_in_space, plates, plates_in_space, turned};
use crate::{K, tied};
use fmc_contact::contact::PairOptions;
use fmc_contact::overlap::Partner::Body;
use fmc_contact::overlap::Warning;
use fmc_contact::{EnergyLaw, Options};
use fmc_shapes::rectangle_quad4;

/// By default; more than both thicknesses, and than all.
const REACHES: [f64; 4] = [0.0, 0.15, 10.0, 1e4];

/// A thin plate on a thick one, and on another thin one.
const THICKNESSES: [[f64; 2]; 3] = [[0.5, 0.03], [0.03, 0.5], [0.02, 0.03]];

/// Rounding of coordinates and of pieces, whose number is some tens.
fn is_near(found: f64, expected: f64) -> bool {
    (found - expected).abs() < 1e-12
}

fn check<const D: usize>(scene: &Scene<D>, reach: f64, bodies: [usize; 2], [area, gap]: [f64; 2]) {
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    contact.set_pair_options(bodies.map(Body), Some(PairOptions::tied(reach))).expect("a tie");
    let tie = contact.tie(bodies).expect("bodies").expect("a tie");
    assert!(is_near(tie.area, area) && is_near(tie.largest_gap, gap), "{tie:?} for {area}, {gap} within {reach}");
    let warnings = contact.evaluate(&scene.coords).expect("an evaluation").warnings;
    assert!(!warnings.iter().any(|warning| matches!(warning, Warning::TiedInPart { .. })), "{warnings:?}");
}

#[test]
fn two_plates_are_tied_once() {
    for thicknesses in THICKNESSES {
        for gap in [0.0, 0.013, -0.013] {
            for angle in [0.0, 0.3] {
                for reach in REACHES {
                    check(&turned(plates(&thicknesses, gap), angle), reach, [0, 1], [1.0, gap.abs()]);
                    check(&turned(plates_in_space(&thicknesses, gap), angle), reach, [0, 1], [1.0, gap.abs()]);
                }
            }
        }
    }
}

/// The one in the middle is tied to both.
#[test]
fn three_plates_are_tied_at_both_joints() {
    for gap in [0.0, 0.004, -0.004] {
        for reach in REACHES {
            for bodies in [[0, 1], [1, 2]] {
                check(&turned(plates(&[0.5, 0.02, 0.3], gap), 0.2), reach, bodies, [1.0, gap.abs()]);
                check(&turned(plates_in_space(&[0.02, 0.01, 0.3], gap), 0.2), reach, bodies, [1.0, gap.abs()]);
            }
        }
    }
}

/// Two wedges that are as thick as nothing at one end.
#[test]
fn wedges_are_tied_to_their_tips() {
    let below = rectangle_quad4([0.0, -1.0], [1.0, 0.0], [4, 1]).mapped(|[x, y]| [x, 0.1 * (x + 1e-3) * y]);
    let above = rectangle_quad4([0.0, 0.0], [1.0, 1.0], [3, 1]).mapped(|[x, y]| [x, 0.1 * (x + 1e-3) * y]);
    for reach in [0.01, 0.1, 10.0] {
        check(&Scene::of(&[&below, &above]), reach, [0, 1], [1.0, 0.0]);
    }
}

/// What is hidden in part is tied in part: every place of the plate is tied to what lies next above it, and bears by that.
#[test]
fn what_is_hidden_in_part_is_tied_elsewhere() {
    for reach in [0.25, 10.0] {
        check(&below_a_shelf(), reach, [0, 1], [1.0, 0.2]);
        check(&below_a_shelf_in_space(), reach, [0, 1], [1.0, 0.2]);
    }
    let (scene, by) = (below_a_shelf(), 1e-3);
    let contact = tied(&scene, 0.25);
    let mut coords = scene.coords.clone();
    coords[scene.first_node[1]..].iter_mut().for_each(|x| x[1] += by);
    let forces = contact.evaluate(&coords).expect("an evaluation").forces;
    for (mesh, area) in [(0, -1.0), (1, 0.35), (2, 0.65)] {
        let force: f64 = scene.nodes_of(mesh).map(|node| forces[node][1]).sum();
        // Means over the nodes of the plate hold shelf and roof together: their shares follow from the hat functions.
        assert!((force + K * by * area).abs() < 1e-10 * K, "{mesh}: {force}");
    }
}
