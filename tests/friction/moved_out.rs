//! Friction of surfaces that multipliers move out: slip is that of the material.

use crate::scene::Scene;
use crate::{begun, in_plane, in_space, laws, raised, slid};
use fmc_contact::contact::Multiplier;
use fmc_contact::{Contact, Options};
use fmc_shapes::Splitmix;

const DELTA: f64 = 1e-3;

/// The blocks after a step of which all but a third was a fall, slid by a part of the penetration, with nodes that do not lie even.
fn uneven<const D: usize>(scene: &Scene<D>, by: f64) -> Vec<[f64; D]> {
    let mut random = Splitmix::new(7);
    let mut coords = slid(scene, by);
    coords.iter_mut().flatten().for_each(|x| *x += 0.1 * DELTA * random.between(-1.0, 1.0));
    coords
}

/// A contact whose surfaces are moved out at `at`, where they press with twice their penetration.
fn moved_out<const D: usize>(scene: &Scene<D>, options: Options, at: &[[f64; D]]) -> Contact<D> {
    let mut contact = begun(scene, options, &raised(scene, 1.5 * DELTA));
    let found = contact.augment(at, 0.1, 0.0).expect("multipliers");
    assert!(found.count > 1 && found.penetration > 0.5 * DELTA, "{found:?}");
    contact
}

fn largest<const D: usize>(forces: &[[f64; D]]) -> f64 {
    forces.as_flattened().iter().fold(0.0, |most, f| most.max(f.abs()))
}

fn difference<const D: usize>(one: &[[f64; D]], other: &[[f64; D]]) -> f64 {
    let all = one.as_flattened().iter().zip(other.as_flattened());
    all.fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

/// Parts of the largest force by which those after an accepted step differ from those before, at the same place.
fn after_commit<const D: usize>(scene: &Scene<D>, options: Options, by: f64) -> f64 {
    let at = uneven(scene, by);
    let mut contact = moved_out(scene, options, &at);
    let before = contact.evaluate(&at).expect("forces");
    assert!(before.friction.slip_area + before.friction.stick_area > 0.0);
    let mut most = 0.0f64;
    for _ in 0..3 {
        contact.commit_step(&at).expect("a step");
        let after = contact.evaluate(&at).expect("forces");
        assert!(after.friction.largest_slip < 1e-12 * DELTA.max(by), "{:?}", after.friction);
        most = most.max(difference(&after.forces, &before.forces) / largest(&before.forces));
    }
    most
}

#[test]
fn an_accepted_step_leaves_all_forces() {
    for (by, coefficient) in [(0.05 * DELTA, 0.3), (3.0 * DELTA, 0.3), (0.5 * DELTA, 5.0)] {
        for options in laws(coefficient) {
            let planes = in_plane(DELTA).map(|scene| after_commit(&scene, options, by));
            let spaces = in_space(DELTA).map(|scene| after_commit(&scene, options, by));
            println!("{:?}, μ {coefficient}, by {by}: {planes:?} {spaces:?}", options.law);
            // Places of order 1 round by 1e-16, of an elastic slip of 1e-4.
            assert!(planes.iter().chain(&spaces).all(|found| *found < 1e-11), "{options:?}: {planes:?} {spaces:?}");
        }
    }
}

/// Turns the plane of the first two axes.
fn turn<const D: usize>(x: [f64; D], angle: f64) -> [f64; D] {
    let (sin, cos) = angle.sin_cos();
    let mut turned = x;
    (turned[0], turned[1]) = (cos * x[0] - sin * x[1], sin * x[0] + cos * x[1]);
    turned
}

/// Bodies that stick, and turn together in one step with what moves their surfaces out.
fn after_turn<const D: usize>(scene: &Scene<D>, options: Options, angle: f64) -> f64 {
    let at = uneven(scene, 0.5 * DELTA);
    let mut contact = moved_out(scene, options, &at);
    contact.commit_step(&at).expect("a step");
    let forces = contact.evaluate(&at).expect("forces").forces;
    let expected: Vec<_> = forces.into_iter().map(|f| turn(f, angle)).collect();
    let multipliers = contact.multipliers();
    let turned: Vec<_> =
        multipliers.into_iter().map(|one| Multiplier { towards: turn(one.towards, angle), ..one }).collect();
    contact.set_multipliers(&turned).expect("multipliers");
    let now: Vec<_> = at.iter().map(|x| turn(*x, angle)).collect();
    difference(&contact.evaluate(&now).expect("forces").forces, &expected) / largest(&expected)
}

#[test]
fn what_turns_as_one_does_not_slip() {
    for (options, angle) in laws(5.0).into_iter().flat_map(|options| [0.1, 1.0].map(|angle| (options, angle))) {
        let found: Vec<f64> = (in_plane(DELTA).iter().map(|scene| after_turn(scene, options, angle)))
            .chain(in_space(DELTA).iter().map(|scene| after_turn(scene, options, angle)))
            .collect();
        println!("{:?} by {angle}: {found:?}", options.law);
        // The law `fiber` measures a contact that turns as a whole to some 1e-7.
        let most = if options.law.is_fiber() { 1e-5 } else { 1e-10 };
        assert!(found.iter().all(|found| *found < most), "{options:?} by {angle}: {found:?}");
    }
}

/// Multipliers that change press otherwise, and slip by nothing: of bodies that stick friction stays as it was.
#[test]
fn surfaces_that_are_moved_out_do_not_slip() {
    for options in laws(5.0) {
        for scene in in_plane(DELTA) {
            let at = uneven(&scene, 0.5 * DELTA);
            let mut contact = moved_out(&scene, options, &at);
            contact.commit_step(&at).expect("a step");
            let before = contact.evaluate(&at).expect("forces");
            let less: Vec<_> =
                contact.multipliers().into_iter().map(|one| Multiplier { shift: 0.9 * one.shift, ..one }).collect();
            contact.set_multipliers(&less).expect("multipliers");
            let after = contact.evaluate(&at).expect("forces");
            let of = |friction: [f64; 2]| friction[0];
            let (was, is) = (of(before.bodies[1].friction), of(after.bodies[1].friction));
            println!("{:?}: {was:e} {is:e}", options.law);
            // The area in contact changes at the rims alone.
            assert!((is - was).abs() < 5e-3 * was.abs(), "{options:?}: {was} {is}");
        }
    }
}

/// A contact that is made anew, with the multipliers of then before its step begins, goes on as the first.
#[test]
fn a_restart_with_multipliers() {
    for options in laws(0.3) {
        for scene in in_plane(DELTA) {
            let at = uneven(&scene, 0.5 * DELTA);
            let mut contact = moved_out(&scene, options, &at);
            contact.commit_step(&at).expect("a step");
            let mut other = scene.contact(options);
            other.set_multipliers(&contact.multipliers()).expect("multipliers");
            other.begin_step(&at).expect("a step");
            other.set_slip(&contact.slip().expect("a step")).expect("a slip");
            let next = uneven(&scene, 0.8 * DELTA);
            assert_eq!(contact.evaluate(&next).expect("forces"), other.evaluate(&next).expect("forces"), "{options:?}");
        }
    }
}

/// Moments of friction about the nodes where they are.
#[test]
fn moments_cancel_about_the_true_places() {
    for options in laws(0.3) {
        for scene in in_plane(DELTA) {
            let at = uneven(&scene, 0.5 * DELTA);
            let contact = moved_out(&scene, options, &at);
            let mut smooth = scene.contact(Options { friction: fmc_contact::contact::Friction::default(), ..options });
            smooth.set_multipliers(&contact.multipliers()).expect("multipliers");
            let (with, without) = (contact.evaluate(&at).expect("forces"), smooth.evaluate(&at).expect("forces"));
            let (mut sum, mut all) = (0.0, 0.0);
            for ((f, g), x) in with.forces.iter().zip(&without.forces).zip(&at) {
                let force = [f[0] - g[0], f[1] - g[1]];
                sum += x[0] * force[1] - x[1] * force[0];
                all += force[0].abs() + force[1].abs();
            }
            assert!(all > 0.01 && sum.abs() < 1e-13 * all, "{options:?}: {sum} of {all}");
        }
    }
}
