//! Archard's law against its closed forms.

use crate::scene::Scene;
use crate::{DELTA, STIFFNESS, WEAR, laws, moved, on_a_plane};
use fmc_contact::contact::PairOptions;
use fmc_contact::overlap::Partner;
use fmc_contact::{Contact, Obstacle, Options, Pose, Shape};
use fmc_shapes::{cuboid_hex8, rectangle_quad4, second_order};

/// A pin that stands DELTA deep in a plane.
fn pins() -> (Vec<Scene<2>>, Vec<Scene<3>>) {
    let flat = rectangle_quad4([0.2, -DELTA], [1.2, 1.0], [4, 3]);
    let second = second_order(&flat, 9);
    (
        vec![Scene::of(&[&flat]), Scene::of(&[&second])],
        vec![Scene::of(&[&cuboid_hex8([0.2, 0.0, -DELTA], [1.2, 0.6, 1.0], [3, 2, 2])])],
    )
}

/// The plane slides by `slip` below the pin, as far as it has come already.
fn slide<const D: usize>(contact: &mut Contact<D>, along: &mut f64, slip: f64) {
    *along += slip;
    let mut place = [0.0; D];
    place[0] = *along;
    contact.set_pose(0, Pose::at(place)).expect("the plane");
}

/// Worn depths of the nodes at the foot of the pin, and of all others.
fn depths<const D: usize>(scene: &Scene<D>, contact: &Contact<D>) -> (Vec<f64>, Vec<f64>) {
    let depth = contact.wear().expect("a step").depth;
    let (foot, others): (Vec<_>, Vec<_>) = scene.coords.iter().zip(depth).partition(|(x, _)| x[D - 1] == -DELTA);
    let of = |nodes: Vec<(&[f64; D], f64)>| nodes.into_iter().map(|(_, depth)| depth).collect();
    (of(foot), of(others))
}

/// Under a constant load the pin goes down as it wears: h = K p s, at corners as in the middle, in a thousand cycles and in ten steps
/// of a hundred cycles each.
fn under_a_load<const D: usize>(scene: &Scene<D>, options: Options, cycles: f64) {
    let mut contact = on_a_plane(scene, options);
    contact.set_wear_cycles(cycles).expect("cycles");
    contact.begin_step(&scene.coords).expect("a step");
    let load = -contact.evaluate(&scene.coords).expect("forces").obstacles[0].force[D - 1];
    let (slip, mut along, mut low) = (0.02, 0.0, 0.0);
    let steps = 1000 / cycles as usize;
    for _ in 0..steps {
        slide(&mut contact, &mut along, slip);
        // Down until the plane carries the load again; it has the stiffness of the law.
        let force = |low: f64| {
            let at = moved(scene, 0, [0.0, -low]);
            -contact.evaluate(&at).expect("forces").obstacles[0].force[D - 1] - load
        };
        let [before, after] = [force(low), force(low + 0.1 * DELTA)];
        low -= 0.1 * DELTA * before / (after - before);
        contact.commit_step(&moved(scene, 0, [0.0, -low])).expect("a step");
    }
    // Of friction the stick gives way once, by the limit by the stiffness.
    let stick = options.friction.coefficient * DELTA / steps as f64;
    let expected = WEAR[0] * STIFFNESS * DELTA * (slip - stick) * 1000.0;
    let (foot, others) = depths(scene, &contact);
    // The walls are pressed as far as they lie in the plane, by half of the pressure, and go down along it.
    assert!(!foot.is_empty() && others.iter().all(|depth| *depth < DELTA * expected), "{others:?} {expected}");
    // What the walls lose lies across that, and is DELTA of it at most; with friction they bear a part of the load of this size.
    let most = if options.friction.coefficient > 0.0 { DELTA } else { 1e-7 };
    assert!(foot.iter().all(|depth| (depth / expected - 1.0).abs() < most), "{foot:?} {expected}");
    // The pin is lower by what it lost, but for the last step and the walls.
    let last = expected / steps as f64;
    assert!((low + last - expected).abs() < DELTA * expected, "{low} {expected}");
}

#[test]
fn a_thousand_cycles_under_a_constant_load() {
    let (flat, solid) = pins();
    for coefficient in [0.0, 0.3] {
        for options in laws(coefficient) {
            flat.iter().for_each(|scene| under_a_load(scene, options, 100.0));
            solid.iter().for_each(|scene| under_a_load(scene, options, 100.0));
        }
    }
    under_a_load(&flat[0], laws(0.3)[0], 1.0);
    under_a_load(&solid[0], laws(0.0)[0], 10.0);
}

/// Held in its place, the pin wears until nothing presses: dh = K k (δ − h) ds, h = δ (1 − exp(−K k s)).
#[test]
fn a_pin_that_is_held_wears_itself_free() {
    let (flat, _) = pins();
    for options in laws(0.0) {
        let mut contact = on_a_plane(&flat[0], options);
        contact.begin_step(&flat[0].coords).expect("a step");
        let (steps, mut along) = (1000, 0.0);
        let slip = 2.0 / (WEAR[0] * STIFFNESS * f64::from(steps));
        for _ in 0..steps {
            slide(&mut contact, &mut along, slip);
            contact.commit_step(&flat[0].coords).expect("a step");
        }
        let (foot, _) = depths(&flat[0], &contact);
        let (exact, by_steps) = (1.0 - (-2.0f64).exp(), 1.0 - (1.0 - 2.0 / f64::from(steps)).powi(steps));
        for depth in foot {
            // Steps are explicit: what is left of the penetration is too small by K k ds of it, here 2 permille in sum. Rounding apart, it
            // is (1 − K k ds)^n.
            assert!((depth / DELTA - by_steps).abs() < 1e-9 && (depth / (DELTA * exact) - 1.0).abs() < 5e-3);
        }
    }
}

/// The end of a pin of revolution, over which a plane slides outwards, as a foil that is drawn over it.
#[test]
fn a_pin_of_revolution() {
    let scene = Scene::of(&[&rectangle_quad4([0.0, -DELTA], [1.0, 1.0], [6, 3])]);
    let mut contact = scene.contact(Options { axisymmetric: true, ..laws(0.0)[0] });
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 2]) }).expect("an obstacle");
    let partners = [Partner::Body(0), Partner::Obstacle(0)];
    let own = PairOptions::with_wear([WEAR[0], 0.0]);
    contact.set_pair_options(partners, Some(own)).expect("a pair that wears");
    contact.begin_step(&scene.coords).expect("a step");
    // All nodes go outwards by a part of their radius, which is small: slip is that of a facet that is stretched by half.
    let part = 1e-6;
    let mut coords = scene.coords.clone();
    coords.iter_mut().for_each(|x| x[0] *= 1.0 + part);
    contact.commit_step(&coords).expect("a step");
    let found = contact.wear().expect("a step");
    let pressure = STIFFNESS * DELTA;
    let rings = (0..6).map(|ring| {
        let ends = [f64::from(ring) / 6.0, f64::from(ring + 1) / 6.0];
        let area = std::f64::consts::PI * (ends[1].powi(2) - ends[0].powi(2));
        // By area, its mean radius.
        let mean = 2.0 / 3.0 * (ends[1].powi(3) - ends[0].powi(3)) / (ends[1].powi(2) - ends[0].powi(2));
        WEAR[0] * pressure * part * mean * area
    });
    let expected: f64 = rings.sum();
    // Rounding of places of 1, by a slip of 1e-6; the stretch itself; and the rim, of a width of DELTA.
    assert!((found.volumes[0] / expected - 1.0).abs() < 1e-5, "{found:?} {expected}");
}
