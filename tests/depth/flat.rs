//! Flat faces: the pressure is k times the penetration, up to the rim.

use crate::depth;
use crate::scene::Scene;
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3};

/// Force of a block pressed into an equal one, by k δ A; h is the size of a cell.
fn stiffness<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>, depth_by_h: f64, h: f64) -> f64 {
    let delta = depth_by_h * h;
    let scene = Scene::of(&[lower, upper]);
    let contact = scene.contact(depth(1.0));
    let mut coords = scene.coords.clone();
    scene.nodes_of(1).for_each(|n| coords[n][D - 1] -= delta);
    let found = contact.evaluate(&coords).expect("valid coordinates");
    assert!((found.bodies[0].force[D - 1] + found.bodies[1].force[D - 1]).abs() < 1e-12 * delta);
    found.bodies[1].force[D - 1] / delta
}

/// All walls are flush. Within δ of them either depth is the distance from the wall: 1 − δ in the plane, where the depth
/// is the true distance. In space the rim of the contact, as wide as the ball in a cell by the surface, carries less by
/// O(δ / its radius): 2e-3 at δ = 5e-4 h.
#[test]
fn equal_blocks_with_flush_walls() {
    let plane = |n: usize| {
        [Diagonals::Same, Diagonals::Alternating].map(|diagonals| {
            let block = |low: f64| rectangle_tri3([0.0, low], [1.0, low + 1.0], [n, n], diagonals);
            stiffness(&block(-1.0), &block(0.0), 5e-4, 1.0 / n as f64)
        })
    };
    for n in [3, 8] {
        let expected = 1.0 - 5e-4 / n as f64;
        for found in plane(n) {
            assert!((found - expected).abs() < 1e-9, "Tri3, {n}: {found}");
        }
        let block = |low: f64| rectangle_quad4([0.0, low], [1.0, low + 1.0], [n, n]);
        let found = stiffness(&block(-1.0), &block(0.0), 5e-4, 1.0 / n as f64);
        assert!((found - expected).abs() < 1e-9, "Quad4, {n}: {found}");
    }
    for layers in [2, 4] {
        // With two layers cells are twice as deep as wide.
        let h = 0.25;
        let solid = |low: f64| ([0.0, 0.0, low], [1.0, 1.0, low + 1.0], [4, 4, layers]);
        let (p, q) = (solid(-1.0), solid(0.0));
        let found = stiffness(&cuboid_tet4(p.0, p.1, p.2), &cuboid_tet4(q.0, q.1, q.2), 5e-4, h);
        assert!((found - 1.0).abs() < 2e-3, "Tet4, {layers}: {found}");
        let found = stiffness(&cuboid_hex8(p.0, p.1, p.2), &cuboid_hex8(q.0, q.1, q.2), 5e-4, h);
        assert!((found - 1.0).abs() < 2e-3, "Hex8, {layers}: {found}");
    }
}

/// A plate one cell thick in the middle of a block's face, with the true distance from its walls: per area 1 − δ / 2 w in
/// the plane, 1 − δ / w + ⅔ (δ / w)² in space. In tetrahedra the depth is less where the ridge in the middle of the plate
/// runs through them: by up to a tenth of the part of the thickness that is sunk in.
#[test]
fn plates_one_cell_thick() {
    let (t, width) = (0.1, 0.4);
    for by_t in [1e-2, 0.1, 0.4] {
        let part = by_t * t / width;
        let plate = rectangle_tri3([0.3, 0.0], [0.7, t], [4, 1], Diagonals::Alternating);
        let block = rectangle_tri3([0.0, -1.0], [1.0, 0.0], [7, 7], Diagonals::Alternating);
        let (found, expected) = (stiffness(&block, &plate, by_t, t) / width, 1.0 - 0.5 * part);
        assert!((found - expected).abs() < 1e-9, "Tri3, {by_t}: {found} for {expected}");
        let block = cuboid_tet4([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [5, 5, 5]);
        let (low, high, cells) = ([0.3, 0.3, 0.0], [0.7, 0.7, t], [4, 4, 1]);
        let expected = 1.0 - part + 2.0 / 3.0 * part * part;
        let in_space = |plate: Mesh<3>| stiffness(&block, &plate, by_t, t) / (width * width);
        let found = in_space(cuboid_hex8(low, high, cells));
        assert!((found - expected).abs() < 1e-9, "Hex8, {by_t}: {found} for {expected}");
        let found = in_space(cuboid_tet4(low, high, cells));
        println!("{by_t}: {found} for {expected}");
        assert!(found < expected && found > expected - 0.1 * by_t, "Tet4, {by_t}: {found} for {expected}");
    }
}
