//! The volume that is worn off: K times ∫ p ds, and what the surfaces lose.

use crate::scene::Scene;
use crate::{DELTA, STIFFNESS, WEAR, in_plane, in_space, laws, moved, on_a_plane, wearing};
use fmc_contact::{Contact, Options, Pose};
use fmc_shapes::{cuboid_hex8, disc_tri3, rectangle_quad4};

/// A block slides over a plate, and both lose K/μ of the work of friction, whatever the meshes are.
fn by_work<const D: usize>(scene: &Scene<D>, options: Options) {
    let mut contact = wearing(scene, options);
    contact.begin_step(&scene.coords).expect("a step");
    let mut work = 0.0;
    for step in 1..=10 {
        let coords = moved(scene, 1, [0.02 * f64::from(step), 0.0]);
        work += contact.evaluate(&coords).expect("forces").friction.dissipated;
        contact.commit_step(&coords).expect("a step");
        let found = contact.wear().expect("a step").volumes;
        for (volume, coefficient) in found.iter().zip(WEAR) {
            let expected = coefficient * work / options.friction.coefficient;
            // What facets of either side bear differs at the rim, of a width of DELTA.
            assert!((volume / expected - 1.0).abs() < 1e-3, "{step}: {volume} {expected} {:?}", options.law);
        }
        // Each side bears a half of the work, and both together all of it: to rounding of ten sums.
        let mean: f64 = found.iter().zip(WEAR).map(|(volume, coefficient)| 0.5 * volume / coefficient).sum();
        assert!((mean * options.friction.coefficient / work - 1.0).abs() < 1e-12, "{step}: {mean} {work}");
    }
}

#[test]
fn both_bodies_lose_their_part_of_the_work() {
    for options in laws(0.3) {
        in_plane().iter().for_each(|scene| by_work(scene, options));
        in_space().iter().for_each(|scene| by_work(scene, options));
    }
}

/// Volume by which the body reaches into the plane, as its surface is measured.
fn overlap<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> f64 {
    contact.overlaps(coords).expect("overlaps").iter().map(|overlap| overlap.volume).sum()
}

/// What was worn off is what the surface lost, measured without a look at any depth.
fn by_overlap<const D: usize>(scene: &Scene<D>, options: Options, slip: f64, most: f64) {
    let mut contact = on_a_plane(scene, options);
    contact.begin_step(&scene.coords).expect("a step");
    let mut place = [0.0; D];
    for step in 1..=5 {
        place[0] = slip * f64::from(step);
        contact.set_pose(0, Pose::at(place)).expect("the plane");
        let before = overlap(&contact, &scene.coords);
        let lost = contact.wear().expect("a step").volumes[0];
        contact.commit_step(&scene.coords).expect("a step");
        let lost = contact.wear().expect("a step").volumes[0] - lost;
        let gone = before - overlap(&contact, &scene.coords);
        assert!(lost > 0.0 && (gone / lost - 1.0).abs() < most, "{step}: {gone} {lost} {:?}", options.law);
    }
}

#[test]
fn the_surface_loses_what_is_worn_off() {
    let flat = Scene::of(&[&rectangle_quad4([0.0, -DELTA], [1.0, 1.0], [3, 2])]);
    let solid = Scene::of(&[&cuboid_hex8([0.0, 0.0, -DELTA], [1.0, 0.7, 1.0], [3, 2, 2])]);
    for options in laws(0.0).into_iter().chain(laws(0.3)) {
        by_overlap(&flat, options, 0.1, 1e-9);
        // Walls along the way are pressed as far as they lie in the plane, and slide.
        by_overlap(&solid, options, 0.1, 5.0 * DELTA);
    }
    // Of a disc, facets at the rim of the contact are worn beyond it, where the overlap does not see it, on an eighth of the contact each.
    let disc = Scene::of(&[&disc_tri3(1.0, 60).translated([0.0, 0.98])]);
    by_overlap(&disc, laws(0.0)[0], 1e-3, 0.2);
}

/// The sum over contact points of what each loses, by its own pressure: ∫ K p ds.
#[test]
fn contact_points_tell_the_same() {
    let disc = Scene::of(&[&disc_tri3(1.0, 60).translated([0.0, 0.98])]);
    for options in laws(0.0) {
        let mut contact = on_a_plane(&disc, options);
        contact.begin_step(&disc.coords).expect("a step");
        let slip = 0.01;
        contact.set_pose(0, Pose::at([slip, 0.0])).expect("the plane");
        let force = contact.evaluate(&disc.coords).expect("forces").obstacles[0].force;
        let points = contact.contact_points(&disc.coords).expect("points");
        let pressed: f64 = points.iter().map(|point| point.pressure * point.area).sum();
        contact.commit_step(&disc.coords).expect("a step");
        let found = contact.wear().expect("a step").volumes[0];
        // Facets are inclined by 0.2 at most, and slip along themselves.
        assert!((found / (WEAR[0] * pressed * slip) - 1.0).abs() < 0.02, "{found} {pressed}");
        assert!((found / (WEAR[0] * force[1].abs() * slip) - 1.0).abs() < 0.03, "{found} {force:?}");
        assert!(found > 0.0 && STIFFNESS > 0.0);
    }
}
