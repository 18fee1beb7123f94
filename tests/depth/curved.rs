//! Straight facets that stand for round surfaces: told where they lie farther beside them than the sides penetrate.

use crate::depth;
use crate::scene::Scene;
use fmc_contact::overlap::Partner;
use fmc_contact::{ContactForces, Obstacle, Pose, Shape, Warning};
use fmc_shapes::{Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, regular_polygon, second_order};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// A quarter of a ring: a rectangle with its first coordinate around and its second outwards.
fn sector<const D: usize>(mut mesh: Mesh<D>) -> Mesh<D> {
    for x in &mut mesh.coords {
        let (angle, radius) = (FRAC_PI_2 * x[0], x[1]);
        // Against the clock outwards and around is a left-handed pair.
        (x[0], x[1]) = (radius * angle.sin(), radius * angle.cos());
    }
    mesh
}

fn told<const D: usize>(found: &ContactForces<D>) -> Option<[f64; 2]> {
    found.warnings.iter().find_map(|warning| match warning {
        &Warning::CurvedFaces { a: Partner::Body(0), b: Partner::Body(1), sag, penetration, .. } => {
            Some([sag, penetration])
        }
        _ => None,
    })
}

/// Rings of n and m facets a quarter, on a radius of 1, pressed by δ: facets of length h have arcs that rise h²/8 above them, and the
/// last facets of the quarter have none, since nothing goes on beside them.
fn rises([n, m]: [f64; 2]) -> f64 {
    let rise = |n: f64| (FRAC_PI_2 / n).powi(2) / 8.0 * (1.0 - 2.0 / n);
    rise(n) + rise(m)
}

#[test]
fn rings_with_an_interference() {
    for (delta, is_told) in [(1e-4, true), (1e-3, true), (0.05, false)] {
        let inner = sector(rectangle_quad4([0.0, 0.6], [1.0, 1.0 + delta], [8, 2]));
        let outer = sector(rectangle_quad4([0.0, 1.0], [1.0, 1.4], [11, 2]));
        let plane = told(&Scene::of(&[&inner, &outer]).evaluate(depth(1.0)));
        assert_eq!(plane.is_some(), is_told, "{delta}: {plane:?}");
        let along = |from: f64, to: f64, cells| ([0.0, from, 0.0], [1.0, to, 0.2], cells);
        let [(a, b, n), (c, d, m)] = [along(0.6, 1.0 + delta, [8, 2, 1]), along(1.0, 1.4, [11, 2, 1])];
        for [inner, outer] in
            [[cuboid_hex8(a, b, n), cuboid_hex8(c, d, m)], [cuboid_tet4(a, b, n), cuboid_tet4(c, d, m)]]
        {
            let inner = sector(inner);
            let found = told(&Scene::of(&[&inner, &sector(outer)]).evaluate(depth(1.0)));
            assert_eq!(found.is_some(), is_told, "{delta}: {found:?}");
            // Faces that touch by waves touch somewhere on their facets.
            let [sag, _] = found.unwrap_or([rises([8.0, 11.0]), 0.0]);
            assert!((sag / rises([8.0, 11.0]) - 1.0).abs() < 0.4, "{delta}: {sag:e}");
        }
        if let Some([sag, penetration]) = plane {
            assert!((sag / rises([8.0, 11.0]) - 1.0).abs() < 0.4, "{delta}: {sag:e}");
            assert!(penetration > 0.0 && penetration < 1.5 * rises([8.0, 11.0]) + delta);
        }
    }
}

/// Two bodies of second order, or smoothed, are measured as curved.
#[test]
fn curved_bodies_are_not_told() {
    let ring = |from: f64, to: f64, cells| sector(second_order(&rectangle_quad4([0.0, from], [1.0, to], cells), 9));
    let [inner, outer] = [ring(0.6, 1.0 + 1e-4, [8, 2]), ring(1.0, 1.4, [11, 2])];
    assert!(told(&Scene::of(&[&inner, &outer]).evaluate(depth(1.0))).is_none());
    let [inner, outer] = [([0.0, 0.6], [1.0, 1.0 + 1e-4], [8, 2]), ([0.0, 1.0], [1.0, 1.4], [11, 2])]
        .map(|(from, to, cells)| sector(rectangle_quad4(from, to, cells)));
    let scene = Scene::of(&[&inner, &outer]);
    let mut contact = scene.contact(depth(1.0));
    contact.set_surface_smoothing(30.0).expect("an angle");
    assert!(told(&contact.evaluate(&scene.coords).expect("valid coordinates")).is_none());
}

/// Flat faces, also beside a chamfer, and bodies with corners have nothing to tell.
#[test]
fn flat_faces_are_not_told() {
    let mut block = rectangle_quad4([0.0, 0.0], [1.0, 1.0], [6, 6]);
    // The lower corners are cut at an angle of 27° and one of 45°.
    (block.coords[0], block.coords[6]) = ([0.0, 0.08], [0.92, 0.08]);
    let floor = rectangle_quad4([-1.0, -1.0], [2.0, 1e-6], [7, 3]);
    let found = Scene::of(&[&block, &floor]).evaluate(depth(1.0));
    assert!(found.volume > 0.0 && told(&found).is_none(), "{:?}", found.warnings);
    let octagon = fmc_shapes::fan_tri3([0.0; 2], &regular_polygon(8, 1.0));
    let height = (std::f64::consts::PI / 8.0).cos();
    let turned = octagon.rotated(std::f64::consts::PI / 8.0);
    let floor = rectangle_quad4([-2.0, -3.0], [2.0, 1e-7 - height], [7, 3]);
    let found = Scene::of(&[&turned, &floor]).evaluate(depth(1.0));
    assert!(found.volume > 0.0 && told(&found).is_none(), "{:?}", found.warnings);
}

/// A pin in the hole of a rigid body.
#[test]
fn obstacles() {
    let pin = sector(rectangle_quad4([0.0, 0.6], [1.0, 1.0 + 1e-4], [8, 2]));
    let mut contact = Scene::of(&[&pin]).contact(depth(1.0));
    let distance = |x: &[f64; 2]| (1.0 - x[0].hypot(x[1]), [-x[0] / x[0].hypot(x[1]), -x[1] / x[0].hypot(x[1])]);
    let shape = Shape::SignedDistance(Arc::new(distance));
    contact.add_obstacle(Obstacle { shape, pose: Pose::at([0.0; 2]) }).expect("an obstacle");
    let found = contact.evaluate(&pin.coords).expect("valid coordinates");
    let is_told = |w: &Warning| matches!(w, Warning::CurvedFaces { a: Partner::Body(0), b: Partner::Obstacle(0), .. });
    assert!(found.warnings.iter().any(is_told), "{:?}", found.warnings);
}
