//! The gradient of the exact overlap against central differences of its volume.

use crate::scene::energy_gradient::Differences;
use crate::scene::{Scene, exact};
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::{Mesh, cuboid_hex8, disc_quad4, random_polygon, random_polyhedron, random_rotation, rectangle_quad4};

/// Step of the differences, in sizes of the bodies. Truncation is its square times third derivatives of some 10;
/// rounding is 1e-16 of a volume of 1 over the step: both some 1e-10.
const STEP: f64 = 1e-6;

/// Derivatives of V agree to 1e-7 of the largest, on every node that carries force and on every tenth other.
fn gradient_matches<const D: usize>(scene: &Scene<D>, size: f64) {
    let law = EnergyLaw::Volume { stiffness: 3.0, exponent: 1.0 };
    let contact: Contact<D> = scene.contact(Options { law, ..exact() });
    let differences = Differences { steps: &[STEP * size], tolerance: 1e-7, loaded: 1, others: 10 };
    differences.check(&contact, &scene.coords);
}

#[test]
fn plane_bodies() {
    for seed in 0..8 {
        let size = [1.0, 1e-6, 1e6][seed as usize % 3];
        let put = |mesh: Mesh<2>| mesh.scaled(size);
        let a = random_polygon(9, 1.0, 0.5, seed);
        let b = random_polygon(6, 0.8, 0.5, seed + 30).translated([0.7, 0.4]);
        gradient_matches(&Scene::of(&[&put(a), &put(b)]), size);
    }
    let block = rectangle_quad4([-1.0; 2], [1.0, 0.0], [7, 4]).jittered(0.25, 1, |_| true);
    gradient_matches(&Scene::of(&[&block, &disc_quad4(0.6, 20).rotated(0.1).translated([0.1, 0.45])]), 1.0);
}

#[test]
fn solid_bodies() {
    for seed in 0..3 {
        let size = [1.0, 1e-6, 1e6][seed as usize % 3];
        let put = |mesh: Mesh<3>| mesh.scaled(size);
        let a = random_polyhedron(1, 1.0, 0.3, 1, seed);
        let b =
            random_polyhedron(0, 0.7, 0.3, 2, seed + 30).rotated_by(random_rotation(seed)).translated([0.7, 0.5, 0.3]);
        gradient_matches(&Scene::of(&[&put(a), &put(b)]), size);
    }
}

#[test]
fn hexahedra_with_curved_faces() {
    let a = cuboid_hex8([0.0; 3], [1.0; 3], [2; 3]).jittered(0.3, 3, |_| true);
    let b = cuboid_hex8([0.0; 3], [0.8; 3], [2, 1, 2]).jittered(0.3, 4, |_| true);
    let b = b.rotated([0.3, 1.0, 0.2], 0.7).translated([0.5, 0.6, 0.55]);
    gradient_matches(&Scene::of(&[&a, &b]), 1.0);
}

#[test]
fn bodies_without_cells() {
    let a = random_polyhedron(1, 1.0, 0.3, 1, 8).boundary();
    let b = random_polyhedron(0, 0.7, 0.3, 1, 9).boundary().translated([0.7, 0.5, 0.3]);
    gradient_matches(&Scene::of(&[&a, &b]), 1.0);
}
