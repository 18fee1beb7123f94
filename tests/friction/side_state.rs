//! What is carried, released and forgotten beside the forces.

use crate::scene::Scene;
use crate::{STIFFNESS, begun, in_plane, laws, raised, slid};
use fmc_contact::contact::{FacetSlip, Friction, PairOptions};
use fmc_contact::overlap::Partner;
use fmc_contact::{EnergyLaw, Obstacle, Options, Pose, Shape};
use fmc_shapes::rectangle_quad4;

/// A facet below two blocks has a slider for each, as if it were alone with it.
#[test]
fn a_facet_that_faces_two_partners_carries_a_slip_for_each() {
    let (widths, slips) = ([0.4, 0.6], [1e-5, -3e-5]);
    let block = |left: f64, width: f64| rectangle_quad4([left, -1e-3], [left + width, 0.5], [1, 1]);
    let below = rectangle_quad4([-1.0, -0.5], [1.0, 0.0], [1, 1]);
    let scene = Scene::of(&[&below, &block(-0.9, widths[0]), &block(0.2, widths[1])]);
    let mut coords = scene.coords.clone();
    for (node, x) in coords.iter_mut().enumerate().skip(4) {
        x[0] += slips[(node - 4) / 4];
    }
    for options in laws(5.0) {
        let carried = |left_out: &[usize]| {
            let mut contact = scene.contact(options);
            for &body in left_out {
                let pair = [Partner::Body(0), Partner::Body(body)];
                contact.set_pair_options(pair, Some(PairOptions::excluded())).expect("a pair");
            }
            contact.begin_step(&scene.coords).expect("valid coordinates");
            contact.commit_step(&coords).expect("a step");
            contact.slip().expect("a step")
        };
        let (both, first, second) = (carried(&[]), carried(&[2]), carried(&[1]));
        let of_table = |list: &[FacetSlip<2>], partner| -> Vec<FacetSlip<2>> {
            list.iter().filter(|one| one.partner == Partner::Body(partner) && !one.is_second).copied().collect()
        };
        for (partner, alone) in [(1, &first), (2, &second)] {
            let own = of_table(&both, partner);
            assert!(own == of_table(alone, partner) && own.len() == 1, "{options:?}: {own:?}");
            let expected = -slips[partner - 1];
            assert!((own[0].slip[0] - expected).abs() < 1e-6 * expected.abs(), "{options:?}: {own:?}");
        }
    }
}

/// A block at rest beside one that slides, on one coarse facet: nothing of that reaches it.
#[test]
fn a_block_at_rest_is_not_dragged_by_one_that_slides_on_the_same_facet() {
    let block = |left: f64| rectangle_quad4([left, -1e-3], [left + 0.5, 0.5], [4, 4]);
    let table = rectangle_quad4([-2.0, -1.0], [2.0, 0.0], [1, 1]);
    let scene = Scene::of(&[&table, &block(-1.0), &block(0.5)]);
    for options in laws(0.3) {
        let mut contact = begun(&scene, options, &scene.coords);
        for step in 1..=20 {
            let coords = slid(&scene, 2e-4 * f64::from(step));
            let found = contact.evaluate(&coords).expect("forces");
            let normal = found.bodies[2].force[1] - found.bodies[2].friction[1];
            assert!(found.bodies[2].friction[0].abs() < 1e-12 * normal, "{options:?}: {:?}", found.bodies[2].friction);
            if step == 20 {
                let [sliding, pressed] = [found.bodies[1].friction[0], found.bodies[1].force[1]];
                assert!((sliding / (-0.3 * pressed) - 1.0).abs() < 1e-9, "{options:?}: {sliding} {pressed}");
            }
            contact.commit_step(&coords).expect("a step");
        }
    }
}

/// Frozen friction stands on the slip that was carried: with another one it is released.
#[test]
fn another_slip_releases_frozen_friction() {
    for options in laws(0.4) {
        let scene = &in_plane(1e-3)[0];
        let (frozen_at, at) = (slid(scene, 1e-4), slid(scene, 5e-4));
        let mut contact = begun(scene, options, &scene.coords);
        contact.freeze_friction(&frozen_at).expect("a step has begun");
        let frozen = contact.evaluate(&at).expect("forces").forces;
        let facets = contact.boundary_facets();
        let slip: Vec<FacetSlip<2>> = (facets.iter().enumerate())
            .map(|(facet, of)| FacetSlip {
                facet,
                partner: Partner::Body(1 - of.body),
                is_second: of.body == 1,
                slip: [1e-5, 0.0],
                slid: 0.0,
            })
            .collect();
        contact.set_slip(&slip).expect("a slip");
        let released = contact.evaluate(&at).expect("forces").forces;
        let mut fresh = begun(scene, options, &scene.coords);
        fresh.set_slip(&slip).expect("a slip");
        assert_eq!(released, fresh.evaluate(&at).expect("forces").forces);
        assert_ne!(released, frozen);
    }
}

/// Facets bear otherwise under another law: what was measured of them when the step began is forgotten, and slip counts from there.
#[test]
fn another_law_forgets_how_facets_bore() {
    let friction = Friction::coulomb(0.4);
    let [depth, fiber] = laws(0.4).map(|options| Options { friction, ..options });
    let scene = &in_plane(1e-3)[0];
    // The blocks are apart when the step begins.
    let (start, at) = (raised(scene, 2e-3), slid(scene, 1e-4));
    for (before, after) in [(depth, fiber), (fiber, depth)] {
        let forces = |options: Options, then: Options| {
            let mut contact = begun(scene, options, &start);
            contact.set_options(then).expect("valid options");
            contact.evaluate(&at).expect("forces").forces
        };
        let smooth = Options { friction: Friction::default(), ..after };
        assert_eq!(forces(before, after), forces(smooth, after));
        assert_ne!(forces(before, after), forces(after, after));
        // A stiffness alone changes nothing of how they bear.
        let softer = Options {
            law: match after.law {
                EnergyLaw::Fiber { .. } => EnergyLaw::fiber(0.5 * STIFFNESS),
                _ => EnergyLaw::depth(0.5 * STIFFNESS),
            },
            ..after
        };
        assert_eq!(forces(softer, after), forces(after, after));
    }
}

/// Frozen friction is that of pairs that are there: an obstacle that is removed, and a pair that is left out, rub no more.
#[test]
fn what_is_gone_or_left_out_does_not_rub_where_friction_is_frozen() {
    let scene = Scene::of(&[&rectangle_quad4([0.0, -1e-3], [1.0, 0.5], [2, 1])]);
    let shifted: Vec<[f64; 2]> = scene.coords.iter().map(|x| [x[0] + 1e-4, x[1]]).collect();
    let floor = |height: f64| Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, height]) };
    for options in laws(0.4) {
        let frozen = |heights: &[f64]| {
            let mut contact = scene.contact(options);
            for &height in heights {
                contact.add_obstacle(floor(height)).expect("an obstacle");
            }
            contact.begin_step(&scene.coords).expect("valid coordinates");
            contact.freeze_friction(&shifted).expect("a step has begun");
            contact
        };
        // The second floor lies deeper, and stays.
        let alone = frozen(&[-5e-4]).evaluate(&shifted).expect("forces").forces;
        assert!(alone.iter().any(|force| force[0] != 0.0));
        let (mut removed, mut left_out) = (frozen(&[0.0, -5e-4]), frozen(&[0.0, -5e-4]));
        removed.remove_obstacle(0).expect("it is there");
        left_out
            .set_pair_options([Partner::Body(0), Partner::Obstacle(0)], Some(PairOptions::excluded()))
            .expect("a pair");
        for contact in [removed, left_out] {
            assert_eq!(contact.evaluate(&shifted).expect("forces").forces, alone, "{options:?}");
        }
    }
}
