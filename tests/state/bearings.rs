//! How facets bore when the step began is forgotten of the pairs that bear otherwise now, and of no others.

use crate::problem::{DELTA, Problem, STIFFNESS, moved, problems};
use crate::scene::fibers;
use fmc_contact::contact::{Friction, PairOptions};
use fmc_contact::overlap::Partner::{Body, Obstacle as Rigid};
use fmc_contact::{Contact, ContactForces, EnergyLaw, FiberOptions, Obstacle, Options, Pose, Shape};

/// Where a body is far from all others.
fn far() -> Obstacle<2> {
    Obstacle { shape: Shape::Ball { radius: 0.1 }, pose: Pose::at([20.0, 0.0]) }
}

/// Problems with friction that is not frozen.
fn rough() -> impl Iterator<Item = Problem> {
    problems().into_iter().filter(|problem| problem.has_friction() && !problem.freezes)
}

/// Forces of a step in which the body touches, after a call within it.
fn forces(problem: Problem, before: impl Fn(&mut Contact<2>), within: impl Fn(&mut Contact<2>)) -> ContactForces<2> {
    let scene = crate::problem::scene();
    let mut contact = problem.contact(&scene);
    before(&mut contact);
    contact.begin_step(&moved(&scene, 0.0, 2.0 * DELTA)).expect("a step");
    within(&mut contact);
    contact.evaluate(&moved(&scene, 3e-4, -2e-4)).expect("forces")
}

fn none(_: &mut Contact<2>) {}

fn on_nodes(found: ContactForces<2>) -> Vec<[f64; 2]> {
    found.forces
}

#[test]
fn options_of_an_obstacle_that_came_later_leave_all_others() {
    for problem in rough() {
        let expected = on_nodes(forces(problem, none, none));
        for options in [PairOptions::with_friction(0.1), PairOptions::with_gap_offset(0.01), PairOptions::excluded()] {
            let found = forces(problem, none, |contact| {
                let index = contact.add_obstacle(far()).expect("an obstacle");
                contact.set_pair_options([Body(1), Rigid(index)], Some(options)).expect("a pair");
            });
            assert_eq!(on_nodes(found), expected, "{:?}, {options:?}", problem.options.law);
        }
    }
}

/// Options of one pair, also where the pair is in contact.
#[test]
fn options_of_a_pair_leave_all_others() {
    for problem in rough() {
        let smooth = Some(PairOptions::with_friction(0.0));
        // Without friction at the wall, from the beginning or from within the step on.
        let at_wall = |contact: &mut Contact<2>| contact.set_pair_options([Body(1), Rigid(1)], smooth).expect("a pair");
        assert_eq!(forces(problem, none, at_wall), forces(problem, at_wall, none), "{:?}", problem.options.law);
    }
}

/// A law of all pairs that a pair with a law of its own does not follow.
#[test]
fn another_law_leaves_pairs_with_a_law_of_their_own() {
    for problem in rough() {
        let other = match problem.options.law {
            EnergyLaw::Fiber(_) => EnergyLaw::depth(STIFFNESS),
            _ => EnergyLaw::fiber(STIFFNESS),
        };
        // Nothing else rubs.
        let own = |contact: &mut Contact<2>| {
            for (pair, coefficient) in [([Body(0), Body(1)], 0.3), ([Body(1), Body(1)], 0.0)] {
                let options = PairOptions { law: Some(problem.options.law), ..PairOptions::with_friction(coefficient) };
                contact.set_pair_options(pair, Some(options)).expect("a pair");
            }
            for pair in [[Body(0), Rigid(0)], [Body(1), Rigid(1)]] {
                contact.set_pair_options(pair, Some(PairOptions::with_friction(0.0))).expect("a pair");
            }
        };
        let change = |contact: &mut Contact<2>| {
            contact.set_options(Options { law: other, ..problem.options }).expect("options");
        };
        let both = |contact: &mut Contact<2>| {
            own(contact);
            change(contact);
        };
        assert_eq!(forces(problem, own, change), forces(problem, both, none), "{:?}", problem.options.law);
    }
}

/// Lines have no part in how facets bear by depths.
#[test]
fn another_estimator_matters_to_lines_alone() {
    for problem in rough() {
        let by_lines = Options { estimator: fibers(FiberOptions::default()).estimator, ..problem.options };
        let change = |contact: &mut Contact<2>| contact.set_options(by_lines).expect("options");
        let is_same = forces(problem, none, change) == forces(problem, change, none);
        assert_eq!(is_same, !problem.options.law.is_fiber(), "{:?}", problem.options.law);
    }
}

/// What was not measured when the step began is not known: slip counts from the start of the step, whichever way a pair came to rub
/// within it.
#[test]
fn pairs_that_come_within_a_step() {
    let itself = [Body(1), Body(1)];
    for problem in rough() {
        let without = |contact: &mut Contact<2>| {
            contact.set_options(Options { self_contact: false, ..problem.options }).expect("options");
        };
        let by_options = |contact: &mut Contact<2>| contact.set_options(problem.options).expect("options");
        let by_pair = |contact: &mut Contact<2>| {
            contact.set_pair_options(itself, Some(PairOptions::default())).expect("a pair");
        };
        let left_out = |contact: &mut Contact<2>| {
            contact.set_pair_options(itself, Some(PairOptions::excluded())).expect("a pair");
        };
        let taken_in = |contact: &mut Contact<2>| contact.set_pair_options(itself, None).expect("a pair");
        let expected = forces(problem, without, by_pair);
        assert_eq!(forces(problem, without, by_options), expected, "{:?}", problem.options.law);
        assert_eq!(forces(problem, left_out, taken_in), expected, "{:?}", problem.options.law);
    }
}

/// Depths below other surfaces are others.
#[test]
fn other_depths_forget_how_facets_bore_by_them() {
    let scene = crate::problem::scene();
    let stretched: Vec<[f64; 2]> = scene.coords.iter().map(|[x, y]| [1.3 * x, 0.7 * y - 0.2 * x]).collect();
    let left: Vec<u32> = scene.nodes_of(1).filter(|&n| scene.coords[n][0] == 1.0).map(|n| n as u32).collect();
    for problem in rough() {
        let smooth = Options { friction: Friction::default(), ..problem.options };
        let no_friction = |contact: &mut Contact<2>| contact.set_options(smooth).expect("options");
        let reference = |contact: &mut Contact<2>| contact.set_reference(&stretched).expect("a mesh");
        let symmetry = |contact: &mut Contact<2>| contact.set_symmetry_nodes(&left).expect("nodes");
        for told in [&reference as &dyn Fn(&mut Contact<2>), &symmetry] {
            // Obstacles know no depth of the mesh, and neither do lines.
            let between_bodies = |contact: &mut Contact<2>| {
                for pair in [[Body(0), Rigid(0)], [Body(1), Rigid(1)]] {
                    contact.set_pair_options(pair, Some(PairOptions::with_friction(0.0))).expect("a pair");
                }
            };
            let found = forces(problem, between_bodies, told);
            if problem.options.law.is_fiber() {
                assert_eq!(found, forces(problem, between_bodies, none));
                continue;
            }
            let unknown = forces(
                problem,
                |contact| {
                    between_bodies(contact);
                    no_friction(contact);
                },
                |contact| {
                    contact.set_options(problem.options).expect("options");
                    told(contact);
                },
            );
            assert_eq!(found, unknown, "{:?}", problem.options.law);
        }
    }
}

/// A surface that lies elsewhere beside its nodes bears elsewhere, against bodies and obstacles alike.
#[test]
fn other_offsets_forget_how_facets_bore_where_they_lay() {
    let aside: Vec<[f64; 2]> =
        (0..crate::problem::scene().coords.len()).map(|n| [0.0, -1e-4 * (n % 3) as f64]).collect();
    for problem in rough() {
        let smooth = Options { friction: Friction::default(), ..problem.options };
        let no_friction = |contact: &mut Contact<2>| contact.set_options(smooth).expect("options");
        let told = |contact: &mut Contact<2>| contact.set_offsets(&aside).expect("offsets");
        let again = |contact: &mut Contact<2>| {
            told(contact);
            contact.set_offsets(&[]).expect("offsets");
        };
        let unknown = forces(problem, no_friction, |contact| {
            contact.set_options(problem.options).expect("options");
            told(contact);
        });
        assert_eq!(forces(problem, none, told), unknown, "{:?}", problem.options.law);
        assert_eq!(forces(problem, none, again), forces(problem, none, none), "{:?}", problem.options.law);
        assert_ne!(forces(problem, told, none), unknown, "{:?}", problem.options.law);
    }
}

/// Surfaces that are moved out against a partner that is left out are where they are again, also against all others.
#[test]
fn what_is_left_out_moves_no_surface_out() {
    let scene = crate::problem::scene();
    let at = moved(&scene, 0.0, -2e-4);
    for problem in problems().into_iter().filter(|problem| !problem.has_friction()) {
        if matches!(problem.options.law, EnergyLaw::Volume { .. }) {
            continue;
        }
        let excluded = Some(PairOptions::excluded());
        for pair in [[Body(0), Body(1)], [Body(1), Rigid(1)]] {
            let mut contact = problem.contact(&scene);
            contact.augment(&at, 0.02, 0.0).expect("multipliers");
            let of_pair = |partners: [fmc_contact::overlap::Partner; 2]| pair.iter().all(|one| partners.contains(one));
            let mut others = contact.multipliers();
            assert!(others.iter().any(|one| of_pair(one.partners)));
            others.retain(|one| !of_pair(one.partners));
            contact.set_pair_options(pair, excluded).expect("a pair");
            let mut expected = problem.contact(&scene);
            expected.set_multipliers(&others).expect("multipliers");
            expected.set_pair_options(pair, excluded).expect("a pair");
            assert_eq!(contact.multipliers(), expected.multipliers(), "{:?}", problem.options.law);
            assert_eq!(contact.evaluate(&at), expected.evaluate(&at), "{:?}", problem.options.law);
        }
    }
}
