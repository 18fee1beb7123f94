//! Tractions of a block on a plane, by closed forms.

use super::{
    DELTA, DIRECTION, MU, ON_FLOOR, across, axes, closed_form, dot, level, on_floor, own, shifted, slid_to_rest,
};
use crate::scene::norm;
use crate::{STIFFNESS, laws};
use fmc_contact::contact::{Friction, OrthotropicFriction, PairOptions, PointOfContact, StaticFriction};
use fmc_contact::{Contact, Obstacle, Options, Pose, Shape};

#[test]
fn the_force_on_a_block_that_slides_is_not_against_its_way() {
    for of_second in [false, true] {
        let friction = OrthotropicFriction { of_second, ..across(DIRECTION) };
        for angle in [0.0, 0.3, 0.9, 1.5, 2.2, 4.0] {
            let (sin, cos) = f64::sin_cos(angle);
            // With memory each step takes the elastic slip nearer to its end by 3e-4 of what is left.
            for memoryless_slip in [None, Some(1e-3)] {
                let options = Options { friction: Friction { memoryless_slip, ..Friction::default() }, ..laws(0.0)[0] };
                let (scene, mut contact) = on_floor(options, own(friction));
                let way = [cos, sin, 0.0];
                let at = slid_to_rest(&mut contact, &scene.coords, way, 5);
                let expected = closed_form(DIRECTION, MU, way);
                for point in level(contact.contact_points(&at).expect("points")) {
                    let error: [f64; 3] = std::array::from_fn(|i| point.friction[i] / point.pressure - expected[i]);
                    assert!(norm(&[error]) < 1e-12, "{angle}: {:?} {expected:?}", point.friction);
                    assert!(point.sliding == 1.0);
                }
                // Walls that are sunk in bear little.
                let force = contact.evaluate(&at).expect("forces").bodies[0].friction;
                let scale = STIFFNESS * DELTA * 0.8;
                let error: [f64; 3] = std::array::from_fn(|i| force[i] / scale - expected[i]);
                assert!(norm(&[error]) < 2e-3, "{angle}: {force:?} {expected:?}");
            }
        }
    }
}

/// As far as it is pulled to rest: the traction is the point of the ellipse that is nearest to that of the spring, found by bisection.
#[test]
fn the_traction_is_the_nearest_of_the_ellipse() {
    let (scene, mut contact) = on_floor(laws(0.0)[0], own(across(DIRECTION)));
    contact.begin_step(&scene.coords).expect("a step");
    for by in [[3e-4, 1e-4, 0.0], [1e-4, 4e-4, 0.0], [-2e-3, 1e-3, 0.0], [2e-5, 3e-5, 0.0]] {
        let at = shifted(&scene.coords, by);
        let [d, e] = axes(DIRECTION);
        let spring = [dot(d, by), dot(e, by)].map(|s| s / DELTA);
        let is_inside = f64::hypot(spring[0] / MU[0], spring[1] / MU[1]) <= 1.0;
        // The way there has no part along the ellipse at μ₁ cos, μ₂ sin.
        let along = |t: f64| {
            (spring[0].abs() - MU[0] * t.cos()) * -MU[0] * t.sin()
                + (spring[1].abs() - MU[1] * t.sin()) * MU[1] * t.cos()
        };
        let (mut low, mut high) = (0.0, std::f64::consts::FRAC_PI_2);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if along(middle) > 0.0 { low = middle } else { high = middle }
        }
        let nearest = if is_inside {
            spring
        } else {
            [MU[0] * low.cos() * spring[0].signum(), MU[1] * low.sin() * spring[1].signum()]
        };
        for point in level(contact.contact_points(&at).expect("points")) {
            let error: [f64; 3] =
                std::array::from_fn(|i| point.friction[i] / point.pressure + nearest[0] * d[i] + nearest[1] * e[i]);
            assert!(norm(&[error]) < 1e-12, "{by:?}: {error:?}");
            assert_eq!(point.sliding, if is_inside { 0.0 } else { 1.0 });
        }
    }
}

/// Rails: free along them, held across them.
#[test]
fn without_a_coefficient_it_slides_freely() {
    for (mu, direction) in [([0.5, 0.0], [1.0, 0.0, 0.0]), ([0.0, 0.5], [0.0, 1.0, 0.0])] {
        let pair = PairOptions::with_orthotropic_friction(mu[0], OrthotropicFriction::new(mu[1], direction));
        let (scene, mut contact) = on_floor(laws(0.0)[0], Some(pair));
        contact.begin_step(&scene.coords).expect("a step");
        let at = shifted(&scene.coords, [2e-4, 7.0, 0.0]);
        for point in level(contact.contact_points(&at).expect("points")) {
            // It sticks along the first axis: k times the way.
            // To the digits of k times coordinates.
            assert!(
                (point.friction[0] + STIFFNESS * 2e-4).abs() < 1e-9 && point.friction[1].abs() < 1e-12,
                "{point:?}"
            );
            assert!(point.sliding == 0.0);
        }
        let at = shifted(&scene.coords, [2e-2, 7.0, 0.0]);
        for point in level(contact.contact_points(&at).expect("points")) {
            assert!((point.friction[0] + 0.5 * point.pressure).abs() < 1e-12 && point.friction[1].abs() < 1e-12);
            assert!(point.sliding == 1.0);
        }
    }
}

/// Around a circle and back: work is what is stored and dissipated, and no step gains energy.
#[test]
fn dissipation_is_work() {
    for memoryless_slip in [None, Some(1e-5)] {
        let options = Options { friction: Friction { memoryless_slip, ..Friction::default() }, ..laws(0.0)[0] };
        let (scene, mut contact) = on_floor(options, own(across(DIRECTION)));
        contact.begin_step(&scene.coords).expect("a step");
        let count = 400;
        let (mut work, mut lost, mut stored, mut last, mut before) = (0.0, 0.0, 0.0, [0.0; 3], [0.0; 3]);
        for step in 1..=count {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(step) / f64::from(count)).sin_cos();
            let by = [0.01 * sin, 0.01 * (1.0 - cos), 0.0];
            let at = shifted(&scene.coords, by);
            let found = contact.evaluate(&at).expect("forces");
            let force = found.bodies[0].friction;
            // Without memory the traction is that of the step throughout.
            let mean = |i: usize| if memoryless_slip.is_some() { force[i] } else { 0.5 * (force[i] + last[i]) };
            work -= (0..3).map(|i| mean(i) * (by[i] - before[i])).sum::<f64>();
            assert!(found.friction.dissipated >= 0.0);
            (lost, stored) = (lost + found.friction.dissipated, found.friction.stored);
            contact.commit_step(&at).expect("a step");
            (last, before) = (force, by);
        }
        // Of second order in the step, of which there are 400.
        let tolerance = if memoryless_slip.is_some() { 1e-12 } else { 3e-4 };
        assert!((work / (lost + stored) - 1.0).abs() < tolerance, "{work} {lost} {stored}");
        // By the closed form: ∫ |μ∘v| along the circle, for the area and pressure of the face.
        let exact: f64 = (0..1000)
            .map(|k| {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 1e3).sin_cos();
                f64::hypot(MU[0] * cos, MU[1] * sin) * 0.01 * std::f64::consts::TAU / 1e3
            })
            .sum();
        let ratio = lost / (exact * STIFFNESS * DELTA * 0.8);
        assert!((ratio - 1.0).abs() < 2e-2, "{ratio}");
    }
}

/// What rests has a larger ellipse of the same shape.
#[test]
fn limits_at_rest_are_in_the_same_proportion() {
    let at_rest = StaticFriction { coefficient: 0.75, weakening_slip: 0.01 };
    let pair = PairOptions { static_friction: Some(at_rest), ..own(across([1.0, 0.0, 0.0])).expect("options") };
    let (scene, mut contact) = on_floor(laws(0.0)[0], Some(pair));
    contact.begin_step(&scene.coords).expect("a step");
    for (way, rests, slides) in [([1.0, 0.0, 0.0], 0.75, 0.5), ([0.0, 1.0, 0.0], 0.3, 0.2)] {
        let traction = |contact: &Contact<3>, by: f64| {
            let points =
                level(contact.contact_points(&shifted(&scene.coords, way.map(|x: f64| x * by))).expect("points"));
            let of = |point: &PointOfContact<3>| -dot(point.friction, way) / point.pressure;
            assert!(points.iter().all(|point| (of(point) - of(&points[0])).abs() < 1e-12));
            (of(&points[0]), points[0].sliding)
        };
        let (stuck, is_sliding) = traction(&contact, 0.999 * rests * DELTA);
        assert!((stuck - 0.999 * rests).abs() < 1e-12 && is_sliding == 0.0, "{stuck}");
        assert!((traction(&contact, 0.02).0 - rests).abs() < 1e-12);
        let mut after = scene.contact(laws(0.0)[0]);
        after.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 3]) }).expect("a plane");
        after.set_pair_options(ON_FLOOR, Some(pair)).expect("options");
        after.begin_step(&scene.coords).expect("a step");
        after.commit_step(&shifted(&scene.coords, way.map(|x: f64| x * 0.02))).expect("a step");
        assert!((traction(&after, 0.03).0 - slides).abs() < 1e-12);
    }
}
