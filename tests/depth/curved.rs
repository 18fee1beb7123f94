//! Straight facets that stand for round surfaces: told where they lie farther beside them than the sides penetrate.

use crate::depth;
use crate::scene::Scene;
use fmc_contact::overlap::Partner;
use fmc_contact::{ContactForces, Obstacle, Pose, Shape, Warning};
use fmc_shapes::{
    Mesh, cuboid_hex8, cuboid_pyramid5, cuboid_tet4, cuboid_wedge6, rectangle_quad4, regular_polygon, second_order,
};
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

/// A quarter of a cylinder between planes of symmetry: rings with an interference δ have the energy k δ²/2 of each area where they are
/// smoothed, and are told as faceted where they are not.
fn stand_for_rings<const D: usize>(rings: [&Mesh<D>; 2], delta: f64, height: f64) {
    let scene = Scene::of(&rings);
    let mut contact = scene.contact(depth(1.0));
    let plane = |axis: usize, at: f64| {
        let along = |size: f64| std::array::from_fn(|k| if k == axis { size } else { 0.0 });
        [along(at), along(1.0)]
    };
    let mut planes = vec![plane(0, 0.0), plane(1, 0.0)];
    planes.extend((D == 3).then(|| [plane(2, 0.0), plane(2, height)]).into_iter().flatten());
    contact.set_symmetry_planes(&planes).expect("planes");
    let straight = contact.evaluate(&scene.coords).expect("valid coordinates");
    assert!(told(&straight).is_some(), "{:?}", straight.warnings);
    contact.set_surface_smoothing(30.0).expect("an angle");
    let found = contact.evaluate(&scene.coords).expect("valid coordinates");
    let exact = 0.5 * delta * delta * FRAC_PI_2 * if D == 3 { height } else { 1.0 };
    // Coarse faces are wrong by α⁴/90 of the radius: 8 and 11 facets by 2e-5 together, and the energy by twice that, by δ.
    assert!((found.energy / exact - 1.0).abs() < 4e-2, "{} of {exact}", found.energy);
    assert!(told(&found).is_none(), "{:?}", found.warnings);
}

/// Cells of second order with straight edges are smoothed as those of first order are.
#[test]
fn straight_cells_of_second_order() {
    let (delta, height) = (1e-3, 0.2);
    let ranges = [(0.6, 1.0 + delta, 8), (1.0, 1.4, 11)];
    for nodes in [4, 8, 9] {
        let [inner, outer] = ranges.map(|(from, to, count)| {
            let ring = sector(rectangle_quad4([0.0, from], [1.0, to], [count, 2]));
            if nodes == 4 { ring } else { second_order(&ring, nodes) }
        });
        stand_for_rings([&inner, &outer], delta, height);
    }
    type Cuboid = fn([f64; 3], [f64; 3], [usize; 3]) -> Mesh<3>;
    let types: [(Cuboid, usize); 5] =
        [(cuboid_hex8, 20), (cuboid_hex8, 27), (cuboid_tet4, 10), (cuboid_wedge6, 15), (cuboid_pyramid5, 13)];
    for (cuboid, nodes) in types {
        let [inner, outer] = ranges.map(|(from, to, count)| {
            second_order(&sector(cuboid([0.0, from, 0.0], [1.0, to, height], [count, 2, 1])), nodes)
        });
        stand_for_rings([&inner, &outer], delta, height);
    }
}

/// Where faces of second order are curved, straight ones are flat: smoothing leaves both as they are.
#[test]
fn a_mesh_with_its_own_curves_stays_as_it_is() {
    // The lower face is curved, and meets straight ones at 20 degrees.
    let mut block = second_order(&rectangle_quad4([0.0, 0.0], [1.0, 1.0], [1, 1]), 9);
    for x in block.coords.iter_mut().filter(|x| x[1] == 0.0) {
        x[1] -= 0.3 * x[0] * (1.0 - x[0]);
    }
    let floor = rectangle_quad4([-1.0, -1.0], [2.0, -0.05], [7, 3]);
    let scene = Scene::of(&[&block, &floor]);
    let mut contact = scene.contact(depth(1.0));
    let own = contact.evaluate(&scene.coords).expect("valid coordinates");
    contact.set_surface_smoothing(80.0).expect("an angle");
    let smoothed = contact.evaluate(&scene.coords).expect("valid coordinates");
    assert!(own.energy > 0.0 && own.energy.to_bits() == smoothed.energy.to_bits());
}
