//! What is pulled off is held as by a tie; what slides is not.

use crate::scene::Scene;
use crate::{K, in_the_plane, largest, shifted, sliding, some_in_space, with};
use fmc_contact::contact::{GradientRequest, PairOptions};
use fmc_contact::overlap::Partner::{Body, Obstacle as Rigid};
use fmc_contact::{EnergyLaw, Error, Obstacle, Options, Pose, Shape};
use fmc_shapes::rectangle_quad4;

/// The axis across the faces that meet.
fn across<const D: usize>() -> usize {
    D - 1
}

/// Forces of a pull across the faces are those of a tie, whatever was slid along them before; rounding of coordinates of 1 by K.
fn pulls_as_a_tie<const D: usize>(scenes: &[Scene<D>]) {
    for scene in scenes {
        let (held, tied) = (sliding(scene, 0.1), with(scene, PairOptions::tied(0.1)));
        let mut pulled = [0.0; D];
        pulled[across::<D>()] = 1e-3;
        let mut slid = pulled;
        slid[0] = 0.01;
        let [by_tie, found] = [&tied, &held].map(|one| one.evaluate(&shifted(scene, pulled)).expect("an evaluation"));
        let off = found.forces.iter().zip(&by_tie.forces).flat_map(|(a, b)| (0..D).map(|i| (a[i] - b[i]).abs()));
        assert!(off.fold(0.0, f64::max) < 1e-12 * K && found.bodies[0].force[across::<D>()] > 0.5 * 1e-3 * K);
        assert!((found.energy - by_tie.energy).abs() < 1e-14 * K);
        let found = held.evaluate(&shifted(scene, slid)).expect("an evaluation");
        let along = found.forces.iter().flat_map(|f| f[..across::<D>()].iter().map(|f| f.abs())).fold(0.0, f64::max);
        assert!(along < 1e-14 * K, "{:?}: {along:e}", scene.blocks[0].0);
        assert!((found.bodies[0].force[across::<D>()] - by_tie.bodies[0].force[across::<D>()]).abs() < 1e-12 * K);
        slid[across::<D>()] = 0.0;
        let forces = held.evaluate(&shifted(scene, slid)).expect("an evaluation").forces;
        assert!(largest(&forces) < 1e-12 * K);
    }
}

#[test]
fn a_pull_is_that_of_a_tie_and_sliding_has_no_force() {
    for gap in [0.0, 0.03, -0.03] {
        pulls_as_a_tie(&in_the_plane(gap));
        pulls_as_a_tie(&some_in_space(gap));
    }
}

/// Points are found anew where a step begins: the force is by what faces one another there, also where a gap is kept, and presses too.
#[test]
fn what_slides_far_is_held_by_what_is_left() {
    for gap in [0.0, 0.03] {
        for scene in in_the_plane(gap) {
            let mut contact = sliding(&scene, 0.1);
            for (slid, area) in [(0.0, 1.0), (0.3, 0.7), (-0.45, 0.55), (0.9, 0.1)] {
                contact.begin_step(&shifted(&scene, [slid, 0.0])).expect("a step");
                let tie = contact.tie([0, 1]).expect("bodies").expect("a pair that does not separate");
                assert!((tie.area - area).abs() < 1e-12 && (tie.largest_gap - gap).abs() < 1e-12);
                for pulled in [1e-3, -2e-3] {
                    let found = contact.evaluate(&shifted(&scene, [slid, pulled])).expect("an evaluation");
                    assert!((found.bodies[0].force[1] - K * pulled * area).abs() < 1e-12 * K, "{slid} {found:?}");
                    assert!(found.bodies[0].force[0].abs() < 1e-13 * K);
                    let nodes = contact.tie_nodes(&shifted(&scene, [slid, pulled])).expect("nodes");
                    for node in nodes {
                        let sign = if node.bodies[0] == 0 { 1.0 } else { -1.0 };
                        assert!(
                            (node.traction[1] - sign * K * pulled).abs() < 1e-11 * K && node.traction[0].abs() < 1e-12
                        );
                    }
                }
            }
            // A step that would begin beside the other body is refused, and changes nothing.
            let at = shifted(&scene, [0.9, 1e-3]);
            let before = contact.evaluate(&at).expect("an evaluation");
            let beside = contact.begin_step(&shifted(&scene, [1.5, 0.0]));
            assert!(matches!(beside, Err(Error::Untied { bodies: [0, 1], .. })));
            assert_eq!(contact.evaluate(&at).expect("an evaluation"), before);
        }
    }
}

/// A restart: a step that begins at the same coordinates has the same bits, whatever came before.
#[test]
fn a_step_is_that_of_the_coordinates_at_which_it_begins() {
    let scene = &in_the_plane(0.03)[3];
    let (start, end) = (shifted(scene, [0.3, 0.0]), shifted(scene, [0.32, 1e-3]));
    let mut far = sliding(scene, 0.1);
    far.begin_step(&shifted(scene, [-0.2, 0.0])).expect("a step");
    far.commit_step(&start).expect("a step");
    let mut near = sliding(scene, 0.1);
    near.begin_step(&start).expect("a step");
    assert_eq!(far.evaluate(&end), near.evaluate(&end));
}

/// Multipliers press and pull with what the stiffness did, at points that are found anew.
#[test]
fn multipliers_take_the_gap_away() {
    let scene = &in_the_plane(0.0)[1];
    let mut contact = sliding(scene, 0.0);
    let at = shifted(scene, [0.3, 1e-3]);
    assert!(!contact.augment(&at, 0.0, 1e-9).expect("an update").is_enough);
    let closed = contact.evaluate(&shifted(scene, [0.3, 0.0])).expect("an evaluation");
    assert!((closed.bodies[0].force[1] - K * 1e-3 * 0.7).abs() < 1e-12 * K, "{:?}", closed.bodies[0]);
    assert!(contact.augment(&shifted(scene, [0.3, 0.0]), 0.0, 1e-9).expect("an update").is_enough);
    contact.set_multipliers(&[]).expect("none");
    let forces = contact.evaluate(&shifted(scene, [0.3, 0.0])).expect("an evaluation").forces;
    assert!(largest(&forces) < 1e-12 * K);
}

#[test]
fn what_cannot_be_is_refused_and_changes_nothing() {
    let scene = &in_the_plane(0.2)[0];
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 0.0]) }).expect("an obstacle");
    let mut refused = |partners, options| contact.set_pair_options(partners, Some(options)).expect_err("no pair");
    let apart = refused([Body(0), Body(1)], PairOptions::no_separation(0.1));
    assert!(matches!(apart, Error::Untied { bodies: [0, 1], .. }), "{apart}");
    let plain = PairOptions::no_separation(0.3);
    for (partners, options, named) in [
        ([Body(0), Body(1)], PairOptions::no_separation(-0.1), "reach"),
        ([Body(0), Rigid(0)], plain, "does not separate from an obstacle"),
        ([Body(0), Body(0)], plain, "does not separate from itself"),
        ([Body(0), Body(1)], PairOptions { gap_offset: -0.1, ..plain }, "gap offset"),
        ([Body(0), Body(1)], PairOptions { excluded: true, ..plain }, "both excluded and does not separate"),
        ([Body(0), Body(1)], PairOptions { friction_coefficient: Some(0.3), ..plain }, "they slide freely"),
        ([Body(0), Body(1)], PairOptions { law: Some(EnergyLaw::volume(K)), ..plain }, "law volume"),
    ] {
        let error = refused(partners, options);
        assert!(matches!(error, Error::OfPair { .. }) && error.to_string().contains(named), "{error}");
    }
    assert_eq!(contact.pair_options([Body(0), Body(1)]), Ok(None));
    contact.set_pair_options([Body(0), Body(1)], Some(plain)).expect("a pair");
    assert!(matches!(contact.tie_constraints(), Err(Error::Unsupported { .. })));
    let request = GradientRequest { stiffness: true, ..GradientRequest::default() };
    assert!(matches!(contact.vjp(&scene.coords, 1.0, None, &request), Err(Error::Unsupported { .. })));
    // One interface takes the place of another.
    contact.set_pair_options([Body(0), Body(1)], Some(PairOptions::tied(0.3))).expect("a tie");
    let by_tie = contact.evaluate(&shifted(scene, [0.01, 0.01]));
    assert_eq!(by_tie, {
        let mut other = with(scene, PairOptions::tied(0.3));
        other.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 0.0]) }).expect("an obstacle");
        other.evaluate(&shifted(scene, [0.01, 0.01]))
    });
    contact.set_pair_options([Body(0), Body(1)], None).expect("released");
    assert_eq!(contact.tie([0, 1]), Ok(None));
}

/// Other pairs touch as before, and other reference coordinates are found again.
#[test]
fn the_order_of_calls_does_not_matter() {
    let scene = Scene::of(&[
        &rectangle_quad4([0.0, 0.0], [1.0, 0.5], [2, 1]),
        &rectangle_quad4([0.0, 0.5], [1.0, 1.0], [3, 1]),
    ]);
    let wide: Vec<_> = scene.coords.iter().map(|x| [1.5 * x[0], x[1]]).collect();
    let bent: Vec<_> = scene.coords.iter().map(|x| [x[0] + 0.01 * x[1], x[1] + 0.02 * x[0] * x[1]]).collect();
    let mut late = sliding(&scene, 0.0);
    late.begin_step(&bent).expect("a step");
    late.set_reference(&wide).expect("a reference");
    let mut early = scene.contact(Options::new(EnergyLaw::depth(K)));
    early.set_reference(&wide).expect("a reference");
    early.set_pair_options([Body(0), Body(1)], Some(PairOptions::no_separation(0.0))).expect("a pair");
    assert_eq!(early.evaluate(&bent), late.evaluate(&bent));
    assert_eq!(early.tie([0, 1]).expect("bodies").expect("a pair").area, 1.5);
}
