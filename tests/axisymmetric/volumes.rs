//! Volumes of revolution against closed forms, by all estimators.

use crate::exactly;
use crate::scene::{Scene, lines};
use fmc_contact::{EnergyLaw, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Diagonals, Mesh, half_disc_tri3, rectangle_quad4, rectangle_tri3};
use std::f64::consts::PI;

/// A half-disc on the axis, its flat side along z.
fn half_ball_section(edges: usize) -> Mesh<2> {
    half_disc_tri3(1.0, edges).mapped(|[x, y]| [y, -x])
}

/// Volume that the boundary of a section below z = c sweeps: frusta between its nodes.
fn frusta(mesh: &Mesh<2>, c: f64) -> f64 {
    let mut total = 0.0;
    for face in mesh.boundary_faces() {
        let (mut p, mut q) = (mesh.coords[face[0] as usize], mesh.coords[face[1] as usize]);
        // The part below c.
        if p[1] >= c && q[1] >= c {
            continue;
        }
        let at = |p: [f64; 2], q: [f64; 2]| [p[0] + (c - p[1]) / (q[1] - p[1]) * (q[0] - p[0]), c];
        if p[1] > c {
            p = at(p, q);
        } else if q[1] > c {
            q = at(p, q);
        }
        total += PI / 3.0 * (p[0] * p[0] + p[0] * q[0] + q[0] * q[0]) * (q[1] - p[1]);
    }
    total
}

fn volume() -> Options {
    exactly(EnergyLaw::volume(1.0))
}

#[test]
fn ball_below_a_plane_and_in_a_cylinder() {
    let ball = half_ball_section(96);
    for height in [-0.95, -0.4, 0.3] {
        let expected = frusta(&ball, height);
        // A cap: π h² (3R − h)/3, of which 96 edges miss little.
        let cap = PI * (1.0 + height).powi(2) * (2.0 - height) / 3.0;
        assert!((expected / cap - 1.0).abs() < 0.05, "{expected} {cap}");
        let plane = Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, height]) };
        for law in [EnergyLaw::volume(1.0), EnergyLaw::depth(1.0), EnergyLaw::fiber(1.0)] {
            let mut contact = Scene::of(&[&ball]).contact(exactly(law));
            contact.add_obstacle(plane.clone()).unwrap();
            let found = contact.evaluate(&ball.coords).unwrap();
            assert!((found.volume / expected - 1.0).abs() < 1e-12, "{law:?}: {} {expected}", found.volume);
        }
        let cylinder = rectangle_quad4([0.0, -1.5], [1.5, height], [3, 2]);
        for law in [EnergyLaw::volume(1.0), EnergyLaw::depth(1.0)] {
            let found = Scene::of(&[&ball, &cylinder]).evaluate(exactly(law));
            assert!((found.volume / expected - 1.0).abs() < 1e-12, "{law:?}: {} {expected}", found.volume);
        }
        let sampled = Options { axisymmetric: true, ..lines(0.01, 3) };
        let mut contact = Scene::of(&[&ball]).contact(sampled);
        contact.add_obstacle(plane).unwrap();
        let found = contact.evaluate(&ball.coords).unwrap();
        let by = [(found.volume, found.standard_error), {
            let found = Scene::of(&[&ball, &cylinder]).evaluate(sampled);
            (found.volume, found.standard_error)
        }];
        for (found, error) in by {
            assert!((found - expected).abs() < 4.0 * error + 1e-3 * expected, "{found} ± {error}, {expected}");
        }
    }
}

/// Pappus: 2π times the radius of the centroid times the area, for an overlap that is a rectangle, at a distance that
/// costs digits.
#[test]
fn rings() {
    for radius in [0.3, 1.0, 1e3] {
        let inner = rectangle_tri3([radius, 0.0], [radius + 0.5, 1.0], [2, 3], Diagonals::Alternating);
        let outer = rectangle_tri3([radius + 0.499, 0.2], [radius + 1.0, 1.2], [3, 2], Diagonals::Same);
        let expected = PI * 0.8 * ((radius + 0.5).powi(2) - (radius + 0.499).powi(2));
        let found = Scene::of(&[&inner, &outer]).evaluate(volume());
        // Of 1e-3 at a coordinate of 1e3 there are ten digits.
        let rounding = 1e-12 + 1e-15 * radius / 1e-3 * 10.0;
        assert!((found.volume / expected - 1.0).abs() < rounding, "{} {expected}", found.volume);
        // dw/dr of the surfaces: the force of hoops is what their sum has left.
        let hoop: f64 = found.forces.iter().map(|f| f[0]).sum();
        let expected = -2.0 * PI * 0.8 * 1e-3;
        assert!((hoop / expected - 1.0).abs() < 1e-6 * radius.max(1.0), "{hoop} {expected}");
    }
}

/// The same bits on any number of threads.
#[test]
fn threads() {
    let ball = half_ball_section(24);
    let cylinder = rectangle_quad4([0.0, -1.5], [1.5, -0.4], [30, 20]);
    for options in [volume(), exactly(EnergyLaw::depth(3.0)), Options { axisymmetric: true, ..lines(0.01, 3) }] {
        let one = Scene::of(&[&ball, &cylinder]).evaluate(options);
        assert_eq!(one, Scene::of(&[&ball, &cylinder]).evaluate(Options { threads: 3, ..options }));
    }
}
