//! The force is the derivative of the energy, of the same estimate: lines that stay where they are, one weight per line
//! and no correction. For whatever exponent of the law.

use crate::pairs::{plane_scene, solid_scene};
use crate::scene::energy_gradient::Differences;
use crate::scene::{Scene, consistent_lines};
use fmc_contact::{EnergyLaw, Options};
use fmc_shapes::{Diagonals, cuboid_hex8, rectangle_tri3};

/// Steps of the central differences, in sizes of the bodies. Truncation is the square of the step over the cube of the
/// least slope of a crossing; rounding is 1e-16 over the step. The estimate has a kink where a line passes from one
/// facet to the next, which spoils the difference if it lies within the step; that it lies within the shorter step as
/// well is five times less likely.
const STEPS: [f64; 2] = [1e-6, 2e-7];

fn force_is_energy_gradient<const D: usize>(scene: &Scene<D>, options: Options, size: f64) {
    // 1e-6 of the largest force is the project's requirement.
    let differences = Differences { steps: &STEPS.map(|h| h * size), tolerance: 1e-6, loaded: 1, others: 7 };
    differences.check(&scene.contact(options), &scene.coords);
}

fn with_law(options: Options, k: f64, m: f64) -> Options {
    Options { law: EnergyLaw::Volume { stiffness: k, exponent: m }, ..options }
}

#[test]
fn in_2d() {
    for seed in 0..6 {
        let size = [1.0, 1e-3, 1e3][seed as usize % 3];
        let scene = plane_scene(seed).mapped(|x| x.map(|x| x * size));
        for m in [1.0, 1.5, 2.0, 3.0] {
            force_is_energy_gradient(&scene, with_law(consistent_lines(0.03 * size, seed), 2.0, m), size);
        }
    }
}

#[test]
fn in_3d() {
    for seed in 0..3 {
        let size = [1.0, 1e-3, 1e3][seed as usize % 3];
        let scene = solid_scene(seed).mapped(|x| x.map(|x| x * size));
        for m in [1.0, 2.0] {
            force_is_energy_gradient(&scene, with_law(consistent_lines(0.07 * size, seed), 2.0, m), size);
        }
    }
}

/// Faces that are not flat pass their share on to four nodes.
#[test]
fn with_curved_faces() {
    let a = cuboid_hex8([0.0; 3], [1.0; 3], [2; 3]).jittered(0.3, 3, |_| true);
    let b = cuboid_hex8([0.0; 3], [0.8; 3], [2, 1, 2]).jittered(0.3, 4, |_| true);
    let b = b.rotated([0.3, 1.0, 0.2], 0.7).translated([0.5, 0.6, 0.55]);
    force_is_energy_gradient(&Scene::of(&[&a, &b]), consistent_lines(0.06, 1), 1.0);
}

/// Several pairs add up their energies, each with its own pressure.
#[test]
fn of_several_pairs() {
    let block = |k: usize| {
        rectangle_tri3([0.0; 2], [1.0, 0.6], [3, 2], Diagonals::Alternating)
            .rotated(0.1 * k as f64)
            .translated([0.8 * k as f64, 0.1 * (k * k) as f64])
    };
    let scene = Scene::of(&[&block(0), &block(1), &block(2)]);
    force_is_energy_gradient(&scene, with_law(consistent_lines(0.01, 2), 5.0, 2.0), 1.0);
    let contact = scene.evaluate(with_law(consistent_lines(0.01, 2), 5.0, 2.0));
    assert_eq!(contact.pairs.len(), 2);
    let energies: f64 = contact.pairs.iter().map(|p| 5.0 * p.volume * p.volume).sum();
    assert!((contact.energy - energies).abs() < 1e-15 * energies);
    assert!(contact.pairs.iter().all(|p| (p.pressure - 10.0 * p.volume).abs() < 1e-14 * p.pressure));
}
