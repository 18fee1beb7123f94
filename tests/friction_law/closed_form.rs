//! Blocks with one and the same pressure on a plane, pushed along it.

use crate::laws::{Facet, One, capped, stribeck, weakening};
use crate::{DELTA, ON_PLANE, STIFFNESS, along, depth, flat_block, flat_cuboid, moved, on_plane, rub};
use fmc_contact::Contact;

/// Forces on the block along the plane and across it.
fn pushed<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> [f64; 2] {
    let found = contact.evaluate(coords).expect("forces");
    let sum = |axis: usize| found.forces.iter().map(|f| f[axis]).sum();
    [sum(0), sum(D - 1)]
}

/// τ = min(μ p, most): a force of min(μ N, most A), with N = k δ A and A = 1.
#[test]
fn a_pressure_cap() {
    let most = 0.5 * 0.3 * STIFFNESS * DELTA;
    for (deeper, expected) in [(-0.6 * DELTA, 0.3 * STIFFNESS * 0.4 * DELTA), (0.0, most), (DELTA, most)] {
        let (scene, mut contact) = on_plane(&flat_block(), depth());
        rub(&mut contact, ON_PLANE, capped(0.3, most));
        contact.begin_step(&moved(&scene, [0.0, -deeper])).expect("a step");
        let [force, normal] = pushed(&contact, &moved(&scene, [5.0 * DELTA, -deeper]));
        assert!((normal - STIFFNESS * (DELTA + deeper)).abs() < 1e-12, "{normal}");
        assert!((force + expected).abs() < 1e-12 * expected, "{force} {expected}");
        let (scene, mut contact) = on_plane(&flat_cuboid(), depth());
        rub(&mut contact, ON_PLANE, capped(0.3, most));
        contact.begin_step(&moved(&scene, [0.0, 0.0, -deeper])).expect("a step");
        let [force, _] = pushed(&contact, &moved(&scene, [5.0 * DELTA, 0.0, -deeper]));
        // Two walls slide along the plane too, at most by μ k d²/2 each.
        let of_walls = -force - expected;
        assert!(
            of_walls > 0.0 && of_walls < 0.3 * STIFFNESS * (DELTA + deeper).powi(2) * (1.0 + 1e-9),
            "{force} {expected}"
        );
    }
}

/// Stribeck's curve at five speeds, in two steps each: the second begins with the elastic slip of the first.
#[test]
fn a_curve_of_the_speed() {
    let curve = [0.1, 0.2, 0.05, 0.5];
    for speed in [0.1, 0.3, 0.5, 1.0, 4.0] {
        let (scene, mut contact) = on_plane(&flat_block(), depth());
        rub(&mut contact, ON_PLANE, stribeck(curve));
        let time_step = 0.02;
        contact.set_time_step(time_step).expect("a time");
        contact.begin_step(&scene.coords).expect("a step");
        let [a, b, c, v0] = curve;
        let expected = (a + b * (-speed / v0).exp() + c * speed) * STIFFNESS * DELTA;
        for step in 1..=2 {
            let coords = along(&scene, speed * time_step * f64::from(step));
            let [force, _] = pushed(&contact, &coords);
            assert!((force + expected).abs() < 1e-12 * expected, "at {speed}: {force} {expected}");
            contact.commit_step(&coords).expect("a step");
        }
    }
}

/// A rigid block with τ = η v: the speed falls by 1 + η A Δt/m in a step of the implicit Euler method.
#[test]
fn a_block_that_is_slowed_by_a_viscous_film() {
    let (viscosity, mass, time_step): (f64, f64, f64) = (0.7, 2.0, 0.05);
    let film = One(0, move |facet: &Facet| (viscosity * facet.speed(), 0.0, viscosity / facet.time_step, Vec::new()));
    let (scene, mut contact) = on_plane(&flat_block(), depth());
    rub(&mut contact, ON_PLANE, film);
    contact.set_time_step(time_step).expect("a time");
    contact.begin_step(&scene.coords).expect("a step");
    let (mut place, mut speed) = (0.0, 1.0);
    let block = |x: f64| along(&scene, x);
    let direction = vec![[1.0, 0.0]; scene.coords.len()];
    for step in 1..=20 {
        let mut next = speed;
        for iteration in 0.. {
            let coords = block(place + time_step * next);
            let residual = mass * (next - speed) / time_step - pushed(&contact, &coords)[0];
            if residual.abs() < 1e-12 {
                // A law that is linear: one step of Newton's method, and what rounding leaves.
                assert!(iteration <= 2, "{iteration} iterations");
                break;
            }
            let tangent = contact.tangent(&coords, fmc_contact::contact::TangentPart::Full).expect("a tangent");
            let slope: f64 = tangent.product(&direction).iter().map(|f| f[0]).sum();
            next -= residual / (mass / time_step + slope * time_step);
        }
        place += time_step * next;
        speed = next;
        contact.commit_step(&block(place)).expect("a step");
        let expected = (1.0 + viscosity * time_step / mass).powi(-step);
        assert!((speed - expected).abs() < 1e-10, "{speed} {expected}");
    }
}

/// Of a block that slides steadily the law counts the way, less the elastic slip of the start.
#[test]
fn a_coefficient_that_falls_with_the_way() {
    let constants = [0.6, 0.2, 10.0 * DELTA];
    let (scene, mut contact) = on_plane(&flat_block(), depth());
    rub(&mut contact, ON_PLANE, weakening(constants));
    contact.begin_step(&scene.coords).expect("a step");
    let [a, b, l] = constants;
    let pressure = STIFFNESS * DELTA;
    let (mut slid, mut elastic) = (0.0, 0.0);
    for step in 1..=8 {
        let coords = along(&scene, 2.0 * DELTA * f64::from(step));
        let limit = (b + (a - b) * f64::exp(-slid / l)) * pressure;
        let trial = elastic + 2.0 * DELTA;
        let [force, _] = pushed(&contact, &coords);
        assert!((force + limit.min(STIFFNESS * trial)).abs() < 1e-12, "step {step}: {force} {limit}");
        slid += (trial - limit / STIFFNESS).max(0.0);
        elastic = trial.min(limit / STIFFNESS);
        contact.commit_step(&coords).expect("a step");
        let history = contact.friction_history().expect("a history");
        assert!(history.iter().all(|x| (x - slid).abs() < 1e-14), "{history:?} {slid}");
    }
}

/// A coefficient that falls with the temperature of the body, linear over it: every facet has the mean of its own.
#[test]
fn a_coefficient_by_the_temperature() {
    let law = One(0, |facet: &Facet| {
        assert!(facet.fields[1].is_nan(), "a plane has no temperature");
        let coefficient = 0.5 - 0.1 * facet.fields[0];
        (coefficient * facet.pressure, coefficient, 0.0, Vec::new())
    });
    let (scene, mut contact) = on_plane(&flat_block(), depth());
    rub(&mut contact, ON_PLANE, law);
    // From 1 at x = 0.5 to 3 at x = 1.5.
    let temperatures: Vec<f64> = scene.coords.iter().map(|x| 2.0 * x[0]).collect();
    contact.set_law_fields(1, &temperatures).expect("fields");
    contact.begin_step(&scene.coords).expect("a step");
    let [force, _] = pushed(&contact, &along(&scene, 5.0 * DELTA));
    let expected = (0.5 - 0.1 * 2.0) * STIFFNESS * DELTA;
    assert!((force + expected).abs() < 1e-12, "{force} {expected}");
}
