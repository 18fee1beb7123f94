//! Flat rings and discs, for which the law depth has a closed form.

use crate::depth;
use crate::scene::Scene;
use fmc_contact::{Obstacle, Pose, Shape};
use fmc_shapes::{Diagonals, rectangle_quad4, rectangle_tri3};
use std::f64::consts::PI;

const K: f64 = 1e4;

/// F = k δ π (Ro² − Ri²), w = k δ²/2 by area, V = δ π (Ro² − Ri²).
#[test]
fn flat_ring_on_a_plane() {
    for (inner, outer) in [(0.0, 1.0), (0.7, 1.0), (5.0, 5.5)] {
        let delta = 1e-3;
        let meshes = [
            rectangle_tri3([inner, 0.0], [outer, 0.5], [4, 3], Diagonals::Alternating),
            rectangle_quad4([inner, 0.0], [outer, 0.5], [3, 2]),
        ];
        for mesh in meshes {
            let mut contact = Scene::of(&[&mesh]).contact(depth(K));
            let plane = Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, delta]) };
            contact.add_obstacle(plane).unwrap();
            let found = contact.evaluate(&mesh.coords).unwrap();
            let area = PI * (outer * outer - inner * inner);
            let near =
                |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
            near(found.bodies[0].force[1], K * delta * area);
            near(-found.obstacles[0].force[1], K * delta * area);
            near(found.energy, 0.5 * K * delta * delta * area);
            near(found.volume, delta * area);
            // The plane may move sideways: nothing changes.
            assert!(found.obstacles[0].force[0].abs() < 1e-11 * K * delta * area);
            // The bottom, and what of the walls is sunk in.
            near(found.contact_area, area + 2.0 * PI * delta * (inner + outer));
            let points = contact.contact_points(&mesh.coords).unwrap();
            let on_bottom: f64 = points.iter().filter(|point| point.normal[1] < -0.5).map(|point| point.area).sum();
            near(on_bottom, area);
            let nodal = contact.nodal_contact(&mesh.coords).unwrap();
            let on_plane = |node: &usize| mesh.coords[*node][1] == 0.0;
            assert!((0..mesh.coords.len()).filter(on_plane).all(|n| nodal.area[n] > 0.0));
        }
    }
}

/// A disc in the middle of a larger one: the axis is no wall, for either. Two discs of the same size: walls within the
/// penetration of the rim are nearer than the faces.
#[test]
fn axis_is_no_surface() {
    let delta = 1e-3;
    let lower = rectangle_tri3([0.0, -1.0], [2.0, 0.0], [6, 3], Diagonals::Same);
    let upper = rectangle_quad4([0.0, -delta], [1.0, 0.8], [5, 3]);
    let found = Scene::of(&[&lower, &upper]).evaluate(depth(K));
    let force = found.bodies[1].force[1] / (K * delta * PI);
    // The depth below the free wall alone is missing, a triangle of δ by δ at r = 1.
    assert!((force - 1.0).abs() < 2.0 * delta && force < 1.0, "{force}");
    let plane = found.forces.iter().map(|f| f[0].abs()).fold(0.0, f64::max);
    assert!(plane < 2.0 * delta * K * delta * PI, "{plane}");
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
}
