//! Tangents are the derivatives of the forces, whatever the law is, and no rigid motion has any.

use crate::laws::{PointByPoint, bilinear, unsymmetric};
use crate::scene::Scene;
use crate::{field, held, in_space, in_the_plane, largest, plus, waved};
use fmc_contact::Contact;
use fmc_contact::contact::TangentPart;
use fmc_shapes::random_rotation;

fn dot<const D: usize>(a: &[[f64; D]], b: &[[f64; D]]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| a * b).sum()
}

fn turned<const D: usize>(coords: &[[f64; D]]) -> Vec<[f64; D]> {
    let turn = random_rotation::<D>(5);
    let one =
        |x: &[f64; D]| -> [f64; D] { std::array::from_fn(|i| 2.0 + (0..D).map(|j| turn[i][j] * x[j]).sum::<f64>()) };
    coords.iter().map(one).collect()
}

/// Forces and moments balance to rounding. A step of 1e-6 leaves (1e-6)² of curvature, and rounding of 1e-16 by 1e-6: 1e-6 of the tangent is ten
/// thousand times that.
fn differences<const D: usize>(scene: &Scene<D>, contact: &Contact<D>, by: f64) {
    let (coords, step, h) = (waved(scene, by, 0.3), field(&scene.coords, 4.1), 1e-6);
    let (found, tangent) = contact.evaluate_tangent(&coords, TangentPart::Full).expect("an evaluation");
    let force = found.forces.iter().flatten().map(|f| f.abs()).sum::<f64>();
    let sum = |axis: usize| found.forces.iter().map(|f| f[axis]).sum::<f64>().abs();
    let moment = |i: usize, j: usize| {
        coords.iter().zip(&found.forces).map(|(x, f)| x[i] * f[j] - x[j] * f[i]).sum::<f64>().abs()
    };
    assert!((0..D).all(|i| sum(i) < 1e-13 * force && (0..i).all(|j| moment(i, j) < 1e-13 * force)));
    let [more, less] = [h, -h].map(|by| contact.evaluate(&plus(&coords, by, &step)).expect("an evaluation"));
    let change: Vec<_> = plus(&more.forces, -1.0, &less.forces).iter().map(|f| f.map(|f| -f / (2.0 * h))).collect();
    let product = tangent.product(&step);
    let off = largest(&plus(&product, -1.0, &change));
    assert!(off < 1e-6 * largest(&product), "{off:e} of {:e}", largest(&product));
    let other = field(&scene.coords, 7.7);
    let [symmetric, semidefinite] = [TangentPart::Symmetric, TangentPart::Semidefinite]
        .map(|part| contact.tangent(&coords, part).expect("a tangent"));
    let both = 0.5 * (dot(&other, &product) + dot(&step, &tangent.product(&other)));
    let size = largest(&product) * other.len() as f64;
    assert!((both - dot(&other, &symmetric.product(&step))).abs() < 1e-12 * size);
    for seed in 0..5 {
        let d = field(&scene.coords, f64::from(seed));
        assert!(dot(&d, &semidefinite.product(&d)) >= 0.0);
    }
}

fn all<const D: usize>(scenes: &[Scene<D>]) {
    for scene in scenes {
        let mut contact = held(scene, PointByPoint { count: 2, law: unsymmetric });
        differences(scene, &contact, 0.02);
        contact.begin_step(&scene.coords).expect("a step");
        contact.commit_step(&waved(scene, 0.02, 1.1)).expect("a step");
        assert!(contact.law_history().expect("a history").iter().any(|x| *x > 0.0));
        differences(scene, &contact, 0.03);
    }
}

#[test]
fn forces_balance_and_tangents_are_their_derivatives() {
    for gap in [0.0, 0.03] {
        all(&in_the_plane(gap));
        all(&in_space(gap));
    }
}

/// Rounding of coordinates of 3 by a stiffness of 2e3.
#[test]
fn a_rigid_motion_changes_neither_forces_nor_energy() {
    fn of<const D: usize>(scenes: &[Scene<D>]) {
        for scene in scenes {
            let contact = held(scene, PointByPoint { count: 2, law: bilinear });
            let found = contact.evaluate(&turned(&scene.coords)).expect("an evaluation");
            assert!(largest(&found.forces) < 1e-11 && found.energy < 1e-24);
            let strained = waved(scene, 0.01, 0.3);
            let [here, there] =
                [&strained, &turned(&strained)].map(|coords| contact.evaluate(coords).expect("an evaluation"));
            assert!((here.energy - there.energy).abs() < 1e-10 * here.energy);
            let size = |x: &[f64; D]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
            for (a, b) in here.forces.iter().zip(&there.forces) {
                assert!((size(a) - size(b)).abs() < 1e-9);
            }
        }
    }
    of(&in_the_plane(0.03));
    of(&in_space(-0.03));
}
