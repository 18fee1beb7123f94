//! The direction goes along with what carries it.

use super::{BODIES, DELTA, DIRECTION, MU, across, closed_form, dot, level, on_floor, own, slid_to_rest};
use crate::scene::{norm, size_sum};
use crate::{in_space, laws, moved};
use fmc_contact::Pose;
use fmc_contact::contact::OrthotropicFriction;
use fmc_contact::overlap::Partner;

/// A body that was stretched to twice its length carries its direction along, whichever side a facet is of.
#[test]
fn the_direction_goes_along_with_the_deformation() {
    for scene in in_space(DELTA) {
        for carrier in [0, 1] {
            let friction = OrthotropicFriction { of_second: carrier == 1, ..across([1.0, 1.0, 0.4]) };
            let mut contact = scene.contact(laws(0.0)[0]);
            contact.set_pair_options(BODIES, own(friction)).expect("options");
            let stretched = moved(&scene, carrier, |x| [2.0 * x[0], x[1], x[2]]);
            let way = [0.3, 0.5, 0.0];
            contact.begin_step(&stretched).expect("a step");
            let slide = |coords: &[[f64; 3]], by: f64| {
                let mut coords = coords.to_vec();
                scene.nodes_of(1).for_each(|node| (0..2).for_each(|i| coords[node][i] += by * way[i]));
                coords
            };
            let mut at = stretched;
            for _ in 0..6 {
                at = slide(&at, 0.02);
                contact.commit_step(&at).expect("a step");
            }
            at = slide(&at, 0.02);
            let expected = closed_form([2.0, 1.0, 0.0], MU, way);
            let points = level(contact.contact_points(&at).expect("points"));
            // Where facets still come on to one another the elastic slip is not at its end.
            let inside = points.iter().filter(|point| (0..2).all(|i| point.position[i].abs() < 0.25));
            assert!(inside.clone().count() > 0);
            for point in inside {
                let turn = point.friction[0] * expected[1] - point.friction[1] * expected[0];
                let size = norm(&[point.friction]) * norm(&[expected]);
                assert!(turn.abs() < 1e-4 * size, "{carrier}: {:?} {expected:?}", point.friction);
            }
            // Limits are means over facets.
            let pressed: f64 = points.iter().map(|point| point.pressure * point.area).sum();
            let force: [f64; 3] = std::array::from_fn(|i| {
                points.iter().map(|point| point.friction[i] * point.area).sum::<f64>() / pressed
            });
            let error: [f64; 3] = std::array::from_fn(|i| force[i] + expected[i]);
            assert!(norm(&[error]) < 0.02, "{carrier}: {force:?} {expected:?}");
        }
    }
}

/// A rotation about an axis that is none of the mesh.
fn turned(coords: &[[f64; 3]], [axis, angle]: [[f64; 3]; 2]) -> Vec<[f64; 3]> {
    let size = dot(axis, axis).sqrt();
    let axis = axis.map(|x| x / size);
    let (sin, cos) = angle[0].sin_cos();
    let turn = |x: &[f64; 3]| {
        let cross: [f64; 3] = std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            axis[j] * x[k] - axis[k] * x[j]
        });
        std::array::from_fn(|i| x[i] * cos + cross[i] * sin + axis[i] * dot(axis, *x) * (1.0 - cos))
    };
    coords.iter().map(turn).collect()
}

/// All is turned rigidly, but for the coordinates without deformation: forces turn along. Lines of the law `fiber` are others then, by which
/// forces without a direction change by 1e-3, too.
#[test]
fn turning_all_turns_the_forces() {
    for (options, tolerance) in laws(0.0).into_iter().zip([1e-12, 2e-3]) {
        for scene in in_space(DELTA) {
            for of_second in [false, true] {
                let friction = OrthotropicFriction { of_second, ..across(DIRECTION) };
                let found = |turn: [[f64; 3]; 2]| {
                    let mut contact = scene.contact(options);
                    contact.set_pair_options(BODIES, own(friction)).expect("options");
                    contact.begin_step(&turned(&scene.coords, turn)).expect("a step");
                    let at = moved(&scene, 1, |x| [x[0] + 3e-4, x[1] + 2e-4, x[2]]);
                    contact.evaluate(&turned(&at, turn)).expect("forces")
                };
                let straight = found([[0.0, 0.0, 1.0], [0.0; 3]]);
                for turn in [[[0.0, 0.0, 1.0], [std::f64::consts::FRAC_PI_2; 3]], [[1.0, -0.4, 0.7], [2.3; 3]]] {
                    let (here, wanted) = (found(turn), turned(&straight.forces, turn));
                    let error: Vec<[f64; 3]> =
                        here.forces.iter().zip(&wanted).map(|(f, g)| std::array::from_fn(|i| f[i] - g[i])).collect();
                    assert!(
                        size_sum(&error) < tolerance * size_sum(&wanted),
                        "{:?}: {}",
                        options.law,
                        size_sum(&error)
                    );
                    let lost = here.friction.dissipated / straight.friction.dissipated;
                    assert!((lost - 1.0).abs() < 10.0 * tolerance, "{lost}");
                }
            }
        }
    }
}

/// The direction of an obstacle turns with its pose.
#[test]
fn the_direction_of_an_obstacle_is_in_its_frame() {
    let friction = OrthotropicFriction { of_second: true, ..across(DIRECTION) };
    let (scene, mut contact) = on_floor(laws(0.0)[0], own(friction));
    contact.set_pose(0, Pose::at([0.0; 3]).turned_about([0.0, 0.0, 1.0], 0.7)).expect("a pose");
    let way = [0.6, -0.8, 0.0];
    let at = slid_to_rest(&mut contact, &scene.coords, way, 5);
    let [direction] = turned(&[DIRECTION], [[0.0, 0.0, 1.0], [0.7; 3]])[..] else { panic!("one vector") };
    let expected = closed_form(direction, MU, way);
    for point in level(contact.contact_points(&at).expect("points")) {
        let error: [f64; 3] = std::array::from_fn(|i| point.friction[i] / point.pressure - expected[i]);
        assert!(norm(&[error]) < 1e-12, "{:?} {expected:?}", point.friction);
    }
}

/// In which order the two are named, and which of them has the direction where both lie alike, changes nothing.
#[test]
fn no_side_is_preferred() {
    for options in laws(0.0) {
        for scene in in_space(DELTA) {
            let at = moved(&scene, 1, |x| [x[0] + 3e-4, x[1] + 2e-4, x[2]]);
            let found = |pair: [Partner; 2], of_second: bool| {
                let mut contact = scene.contact(options);
                let friction = OrthotropicFriction { of_second, ..across(DIRECTION) };
                contact.set_pair_options(pair, own(friction)).expect("options");
                assert_eq!(contact.pair_options(pair).expect("a pair"), own(friction));
                contact.begin_step(&scene.coords).expect("a step");
                contact.evaluate(&at).expect("forces")
            };
            let [a, b] = BODIES;
            assert_eq!(found([a, b], false), found([b, a], true));
            assert_eq!(found([a, b], true), found([b, a], false));
            let (of_a, of_b) = (found([a, b], false), found([a, b], true));
            let error: Vec<[f64; 3]> =
                of_a.forces.iter().zip(&of_b.forces).map(|(f, g)| std::array::from_fn(|i| f[i] - g[i])).collect();
            assert!(size_sum(&error) < 1e-12 * size_sum(&of_a.forces));
        }
    }
}
