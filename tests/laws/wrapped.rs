//! The fiber law where the contact wraps around: a pin in its hole, a ball in its socket.

use crate::scene::Scene;
use crate::scene::energy_gradient::Differences;
use crate::scene::table::{exactly, uncorrected};
use crate::tangent::deviation;
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::{Mesh, icosphere, regular_polygon};
use std::f64::consts::{PI, SQRT_2};

const K: f64 = 3.0;

fn exact() -> Options {
    exactly(EnergyLaw::fiber(K))
}

fn sampled(spacing: f64) -> Options {
    uncorrected(EnergyLaw::fiber(K), spacing, 0)
}

fn reversed<const D: usize>(mesh: Mesh<D>) -> Mesh<D> {
    let conn = mesh.cells().flat_map(|cell| cell.iter().rev().copied()).collect();
    Mesh { conn, ..mesh }
}

/// A polygon with so many edges in a hole with so many, wider by `gap` (tighter if negative) and moved by `shift`.
fn pin_in_hole(edges: [usize; 2], gap: f64, shift: [f64; 2]) -> Scene<2> {
    let mut ring = regular_polygon(16, 2.0);
    ring.append(&reversed(regular_polygon(edges[1], 1.0 + gap).rotated(0.05)));
    Scene::of(&[&regular_polygon(edges[0], 1.0).translated(shift), &ring])
}

fn ball_in_socket(gap: f64, shift: [f64; 3]) -> Scene<3> {
    let mut socket = icosphere(1.5, 1);
    socket.append(&reversed(icosphere(1.0 + gap, 2)).rotated_by([[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]]));
    Scene::of(&[&icosphere(1.0, 2).translated(shift), &socket])
}

fn kept<const D: usize>(scene: &Scene<D>, options: Options, directions: usize) -> Contact<D> {
    let mut contact = scene.contact(options);
    assert_eq!(contact.keep_patches(&scene.coords).unwrap(), directions);
    contact
}

/// Every so manyeth node that is met.
fn force_is_energy_gradient<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], every: usize) {
    Differences { steps: &[1e-5, 1e-6], tolerance: 1e-6, loaded: every, others: 0 }.check(contact, coords);
}

/// A pin pressed into a hole that is too tight by δ: two directions at right angles, and at α from the nearer of them
/// the pressure k δ/cos α, which over the circle makes 8 ln(1 + √2) k δ R.
#[test]
fn a_press_fit_is_felt_all_around() {
    let depth = 2e-3;
    let scene = pin_in_hole([180, 180], -depth, [0.0; 2]);
    for options in [exact(), sampled(2e-3)] {
        let contact = kept(&scene, options, 2);
        let found = contact.evaluate(&scene.coords).unwrap();
        let inwards: f64 =
            (0..180).map(|n| (0..2).map(|i| -found.forces[n][i] * scene.coords[n][i]).sum::<f64>()).sum();
        // Chords of the polygons lie within π²/(2·180²) = 1.5e-4 of the circle, a tenth of the depth; the borders, four
        // edges of 90, count with both pressures alike.
        let expected = 8.0 * (1.0 + SQRT_2).ln() * K * depth;
        assert!((inwards / expected - 1.0).abs() < 0.06, "{inwards} against {expected}");
        assert!(inwards > 2.0 * PI * K * depth);
    }
}

/// Parts of the patches are a partition of unity that moves with the nodes: the energy has no steps at their borders.
#[test]
fn the_force_is_the_gradient_across_borders() {
    let scene = pin_in_hole([40, 44], 0.01, [0.02, -0.035]);
    for options in [exact(), sampled(3e-3)] {
        force_is_energy_gradient(&kept(&scene, options, 2), &scene.coords, 1);
    }
    let scene = ball_in_socket(-0.03, [0.01, 0.02, 0.0]);
    for options in [exact(), sampled(0.1)] {
        force_is_energy_gradient(&kept(&scene, options, 3), &scene.coords, 41);
    }
}

#[test]
fn the_tangent_is_the_derivative_across_borders() {
    let scene = pin_in_hole([40, 44], 0.01, [0.02, -0.035]);
    for options in [exact(), sampled(3e-3)] {
        let found = deviation(&kept(&scene, options, 2), &scene.coords, 1.0, 1);
        assert!(found < 1e-6, "{found:.1e}");
    }
    let scene = ball_in_socket(-0.03, [0.01, 0.02, 0.0]);
    for options in [exact(), sampled(0.1)] {
        let found = deviation(&kept(&scene, options, 3), &scene.coords, 1.0, 61);
        assert!(found < 1e-6, "{found:.1e}");
    }
}
