//! One energy: forces and tangents are its derivatives, they balance, and no rigid motion has any.

use crate::scene::Scene;
use crate::{K, in_the_plane, largest, shifted, sliding, some_in_space};
use fmc_contact::contact::TangentPart;
use fmc_shapes::random_rotation;

/// A displacement of every node.
fn field<const D: usize>(coords: &[[f64; D]], seed: f64) -> Vec<[f64; D]> {
    let wave = |node: usize, axis: usize| (seed + 1.7 * node as f64 + 2.9 * axis as f64).sin();
    (0..coords.len()).map(|node| std::array::from_fn(|axis| wave(node, axis))).collect()
}

fn moved<const D: usize>(coords: &[[f64; D]], by: f64, step: &[[f64; D]]) -> Vec<[f64; D]> {
    coords.iter().zip(step).map(|(x, d)| std::array::from_fn(|axis| x[axis] + by * d[axis])).collect()
}

fn dot<const D: usize>(a: &[[f64; D]], b: &[[f64; D]]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| a * b).sum()
}

/// Of bodies that have slid by 0.2 where the step begins, so that there is a lever between points that face one another.
fn derivatives<const D: usize>(scenes: &[Scene<D>]) {
    for scene in scenes {
        let mut contact = sliding(scene, 0.1);
        let mut by = [0.0; D];
        by[0] = 0.2;
        contact.begin_step(&shifted(scene, by)).expect("a step");
        by[0] = 0.15;
        let start = shifted(scene, by);
        let (coords, step) = (moved(&start, 0.02, &field(&start, 0.3)), field(&start, 4.1));
        let (found, tangent) = contact.evaluate_tangent(&coords, TangentPart::Full).expect("an evaluation");
        let force = found.forces.iter().flatten().map(|f| f.abs()).sum::<f64>();
        let sums = (0..D).map(|axis| found.forces.iter().map(|f| f[axis]).sum::<f64>().abs());
        assert!(sums.fold(0.0, f64::max) < 1e-13 * force);
        let moment = |i: usize, j: usize| {
            coords.iter().zip(&found.forces).map(|(x, f)| x[i] * f[j] - x[j] * f[i]).sum::<f64>().abs()
        };
        assert!((1..D).all(|j| (0..j).all(|i| moment(i, j) < 1e-13 * force)));
        // Normals turn by h over a facet's size of 1/4 or so: differences of fourth order are off by its fourth power, 1e-13, and by rounding
        // by h, 1e-12 of the terms.
        let h = 1e-4;
        let weights =
            [(1.0, 8.0), (-1.0, -8.0), (2.0, -1.0), (-2.0, 1.0)].map(|(by, weight)| (by * h, weight / (12.0 * h)));
        let at = |by: f64| contact.evaluate(&moved(&coords, by, &step)).expect("an evaluation");
        let (mut slope, mut change) = (0.0, vec![[0.0; D]; coords.len()]);
        for (by, weight) in weights {
            let there = at(by);
            slope += weight * there.energy;
            change = moved(&change, -weight, &there.forces);
        }
        let off = (slope + dot(&found.forces, &step)).abs() / force;
        assert!(off < 1e-9, "{:?}: {off:e}", scene.blocks[0].0);
        let product = tangent.product(&step);
        let off = largest(&moved(&product, -1.0, &change));
        assert!(off < 1e-8 * largest(&product), "{:?}: {off:e}", scene.blocks[0].0);
        let other = field(&start, 7.7);
        let (ab, ba) = (dot(&other, &product), dot(&step, &tangent.product(&other)));
        assert!((ab - ba).abs() < 1e-12 * largest(&product) * other.len() as f64);
        let semidefinite = contact.tangent(&coords, TangentPart::Semidefinite).expect("a tangent");
        assert!(dot(&step, &semidefinite.product(&step)) >= 0.0);
    }
}

#[test]
fn forces_and_tangents_are_derivatives_of_one_energy() {
    for gap in [0.0, 0.03] {
        derivatives(&in_the_plane(gap));
        derivatives(&some_in_space(gap));
    }
}

/// Forces are rounding at rest and after a rigid motion, also where the next step begins: some 1e3 products of K and lengths of 1.
fn rests<const D: usize>(scenes: &[Scene<D>]) {
    for scene in scenes {
        let mut contact = sliding(scene, 0.1);
        let turn = random_rotation::<D>(5);
        let turned = |x: &[f64; D]| -> [f64; D] {
            std::array::from_fn(|i| 2.0 + (0..D).map(|j| turn[i][j] * x[j]).sum::<f64>())
        };
        let turned: Vec<_> = scene.coords.iter().map(turned).collect();
        for begins in [false, true] {
            for coords in [&scene.coords, &turned] {
                if begins {
                    contact.begin_step(coords).expect("a step");
                }
                let found = contact.evaluate(coords).expect("an evaluation");
                assert!(largest(&found.forces) < 1e-12 * K, "{:?}: {:e}", scene.blocks[0].0, largest(&found.forces));
                assert!(found.energy < 1e-24 * K);
            }
        }
    }
}

#[test]
fn no_rigid_motion_has_a_force() {
    for gap in [0.0, 0.03, -0.03] {
        rests(&in_the_plane(gap));
        rests(&some_in_space(gap));
    }
}
