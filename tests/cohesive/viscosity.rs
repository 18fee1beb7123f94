//! Damage that lags behind: backward in time by its own recursion, with the energy that it takes told apart.

use crate::{held, in_space, in_the_plane, largest, law, moved};
use fmc_contact::contact::{Cohesive, Softening, TangentPart};
use fmc_contact::{Contact, Error};

const STIFFNESS: f64 = 50.0 * 4.0 / 0.1;
const BRITTLE: f64 = 100.0;
const ONSET: f64 = 2.0 / STIFFNESS;
const END: f64 = BRITTLE * ONSET;

fn viscous(viscosity: f64) -> Cohesive {
    Cohesive { viscosity, ..law() }
}

fn target(opening: f64, softening: Softening) -> f64 {
    let (q, m) = (opening / ONSET, BRITTLE);
    match softening {
        _ if q <= 1.0 => 0.0,
        Softening::Linear if q >= m => 1.0,
        Softening::Linear => m * (q - 1.0) / (q * (m - 1.0)),
        Softening::Exponential | Softening::Ppr(_) => 1.0 - (-2.0 * (q - 1.0) / (m - 1.0)).exp() / q,
    }
}

fn pull(contact: &Contact<2>, scene: &crate::Scene<2>, opening: f64) -> f64 {
    let forces = contact.evaluate(&moved(scene, [0.0, opening])).expect("an evaluation").forces;
    -forces[scene.first_node[1]..].iter().map(|f| f[1]).sum::<f64>()
}

/// d = (d₀ + r D)/(1 + r) with r = Δt/η, at every end of a step.
#[test]
fn damage_lags_behind_by_its_recursion() {
    let scene = &in_the_plane(0.0)[0];
    for softening in [Softening::Linear, Softening::Exponential] {
        let mut contact = held(scene, Cohesive { softening, ..viscous(0.5) });
        contact.begin_step(&scene.coords).expect("a step");
        let (mut damage, mut most): (f64, f64) = (0.0, 0.0);
        for (time_step, opening) in [
            (0.1, 0.5 * ONSET),
            (0.1, 0.01),
            (0.2, 0.03),
            (0.1, 0.02),
            (0.05, 0.06),
            (1.0, 0.06),
            (1.0, 0.2),
            (0.1, 0.2),
        ] {
            contact.set_time_step(time_step).expect("a time step");
            let (rate, goal) = (time_step / 0.5, target(opening, softening));
            damage = if goal > damage { (damage + rate * goal) / (1.0 + rate) } else { damage };
            let expected = (1.0 - damage) * STIFFNESS * opening;
            let found = pull(&contact, scene, opening);
            // 1 − d is 0.1 or more: rounding of coordinates by the stiffness.
            assert!((found - expected).abs() < 1e-9, "{found} for {expected} at {opening}");
            most = most.max(found);
            contact.commit_step(&moved(scene, [0.0, opening])).expect("a step");
        }
        assert!(most > 10.0, "it carries far more than the strength of 2 while it is pulled so fast: {most}");
    }
}

/// Work by trapezoids, for slow and for fast openings, and while it is held: stored, broken and viscous, to 1e-3 of it.
#[test]
fn what_viscosity_takes_is_told() {
    let scene = &in_the_plane(0.0)[0];
    let mut taken = Vec::new();
    for viscosity in [1e-9, 1e-2, 0.1, 1.0] {
        let mut contact = held(scene, viscous(viscosity));
        contact.begin_step(&scene.coords).expect("a step");
        let count = 4000;
        contact.set_time_step(1.0 / f64::from(count)).expect("a time step");
        let (mut work, mut last) = (0.0, [0.0; 2]);
        let told = |contact: &Contact<2>, opening| {
            contact.cohesive([0, 1], &moved(scene, [0.0, opening])).expect("bodies").expect("an interface")
        };
        for k in 1..=2 * count {
            let opening = 1.2 * END * f64::from(k.min(count)) / f64::from(count);
            let force = pull(&contact, scene, opening);
            work += 0.5 * (force + last[1]) * (opening - last[0]);
            last = [opening, force];
            let now = told(&contact, opening);
            let energy = now.stored + now.dissipated + now.viscous;
            assert!((energy - work).abs() < 1e-3 * (work + 0.01), "{energy} for {work} at {opening}, {viscosity}");
            assert!((contact.evaluate(&moved(scene, [0.0, opening])).expect("one").energy - energy).abs() < 1e-12);
            contact.commit_step(&moved(scene, [0.0, opening])).expect("a step");
        }
        let now = told(&contact, 1.2 * END);
        // Held for a time of 1 it is broken but for e^(−1/η).
        assert!((now.dissipated - 0.1).abs() < if viscosity < 0.05 { 1e-9 } else { 0.1 }, "{}", now.dissipated);
        taken.push(now.viscous);
    }
    assert!(taken[0] < 1e-6 * 0.1 && taken.is_sorted() && taken[3] > 0.1, "{taken:?}");
    // Without viscosity there is none, and no time step is needed.
    let mut contact = held(scene, law());
    contact.begin_step(&scene.coords).expect("a step");
    contact.commit_step(&moved(scene, [0.0, 0.03])).expect("a step");
    assert!(contact.cohesive_history().expect("history").iter().all(|point| *point == Default::default()));
}

/// Four points of the difference, as without viscosity; damage grows in pure opening and in mixed modes.
#[test]
fn tangents_against_differences() {
    for scene in &in_space(0.0) {
        let mut contact = held(scene, viscous(0.2));
        contact.set_time_step(0.1).expect("a time step");
        contact.begin_step(&scene.coords).expect("a step");
        let wave = |seed: f64, node: usize, axis: usize| (seed + 1.7 * node as f64 + 2.9 * axis as f64).sin();
        let at = |by: f64, step: f64| -> Vec<[f64; 3]> {
            let coords = moved(scene, [0.01 * by, 0.02 * by, 0.03 * by]);
            let one = |(node, x): (usize, &[f64; 3])| {
                std::array::from_fn(|i| x[i] + 2e-3 * by * wave(0.3, node, i) + step * wave(4.1, node, i))
            };
            coords.iter().enumerate().map(one).collect()
        };
        let direction: Vec<[f64; 3]> =
            (0..scene.coords.len()).map(|node| std::array::from_fn(|i| wave(4.1, node, i))).collect();
        for by in [0.4, 1.0, 0.9] {
            let tangent = contact.tangent(&at(by, 0.0), TangentPart::Full).expect("a tangent");
            let product = tangent.product(&direction);
            let forces = |step: f64| contact.evaluate(&at(by, step)).expect("an evaluation").forces;
            let h = 1e-6;
            let [a, b, c, d] = [h, -h, 2.0 * h, -2.0 * h].map(forces);
            let change =
                |node: usize, i: usize| -(8.0 * (a[node][i] - b[node][i]) - (c[node][i] - d[node][i])) / (12.0 * h);
            let off: Vec<[f64; 3]> =
                (0..product.len()).map(|node| std::array::from_fn(|i| product[node][i] - change(node, i))).collect();
            assert!(largest(&off) < 1e-6 * largest(&product), "{:e} of {:e}", largest(&off), largest(&product));
            contact.commit_step(&at(by, 0.0)).expect("a step");
        }
        // A restart goes on with the same bits.
        let mut other = held(scene, viscous(0.2));
        other.set_time_step(0.1).expect("a time step");
        other.begin_step(&at(0.9, 0.0)).expect("a step");
        other.set_damage(&contact.damage().expect("damage")).expect("damage");
        other.set_cohesive_history(&contact.cohesive_history().expect("history")).expect("history");
        for by in [1.2, 1.1] {
            assert_eq!(contact.evaluate(&at(by, 0.0)), other.evaluate(&at(by, 0.0)));
            contact.commit_step(&at(by, 0.0)).expect("a step");
            other.commit_step(&at(by, 0.0)).expect("a step");
        }
        assert_eq!(contact.cohesive_history(), other.cohesive_history());
    }
}

#[test]
fn a_viscosity_needs_a_time_step() {
    let scene = &in_the_plane(0.0)[0];
    let mut contact = held(scene, viscous(0.2));
    let missing = contact.evaluate(&scene.coords).expect_err("no time step").to_string();
    assert!(missing.contains("viscosity of a cohesive interface without a time step"), "{missing}");
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(contact.set_time_step(wrong), Err(Error::NotPositive { name: "time_step", .. })));
    }
    contact.set_time_step(0.1).expect("a time step");
    assert!(contact.evaluate(&scene.coords).is_ok());
}
