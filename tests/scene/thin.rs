//! Thin bodies, one on another, in the plane and in space, and turned.

use crate::scene::Scene;
use fmc_shapes::{Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4};

/// Plates of width 1 one above another, each with its thickness, and a gap before the next; where negative they overlap.
pub(crate) fn plates(thicknesses: &[f64], gap: f64) -> Scene<2> {
    stacked(thicknesses, gap, |number, low, high| rectangle_quad4([0.0, low], [1.0, high], [2 + number, 1]))
}

pub(crate) fn plates_in_space(thicknesses: &[f64], gap: f64) -> Scene<3> {
    stacked(thicknesses, gap, |number, low, high| {
        let (from, to) = ([0.0, 0.0, low], [1.0, 1.0, high]);
        if number == 1 { cuboid_tet4(from, to, [1, 2, 1]) } else { cuboid_hex8(from, to, [2, 1, 1]) }
    })
}

fn stacked<const D: usize>(thicknesses: &[f64], gap: f64, mesh: impl Fn(usize, f64, f64) -> Mesh<D>) -> Scene<D> {
    let mut low = 0.0;
    let plate = |(number, thickness): (usize, &f64)| {
        let found = mesh(number, low, low + thickness);
        low += thickness + gap;
        found
    };
    let meshes: Vec<_> = thicknesses.iter().enumerate().map(plate).collect();
    Scene::of(&meshes.iter().collect::<Vec<_>>())
}

/// Turned in the plane of the first and the last axis, in space then in that of the first two.
pub(crate) fn turned<const D: usize>(scene: Scene<D>, angle: f64) -> Scene<D> {
    let (sin, cos) = angle.sin_cos();
    scene.mapped(|mut x| {
        for [i, j] in [[0, D - 1], [0, 1]].into_iter().take(D - 1) {
            (x[i], x[j]) = (cos * x[i] - sin * x[j], sin * x[i] + cos * x[j]);
        }
        x
    })
}

/// A plate below a shelf over a part of it, and a roof above both, of one body: gaps of 0.05 and 0.2. In front of the plate lie 0.35 (in space
/// 0.35 · 0.5) of the shelf.
pub(crate) fn below_a_shelf() -> Scene<2> {
    let plate = rectangle_quad4([0.0, 0.0], [1.0, 0.1], [2, 1]);
    let shelf = rectangle_quad4([0.25, 0.15], [0.6, 0.2], [1, 1]);
    let roof = rectangle_quad4([0.0, 0.3], [1.0, 0.4], [3, 1]);
    Scene::new().with(&plate, 0).with(&shelf, 1).with(&roof, 1)
}

pub(crate) fn below_a_shelf_in_space() -> Scene<3> {
    let plate = cuboid_hex8([0.0; 3], [1.0, 1.0, 0.1], [2, 1, 1]);
    let shelf = cuboid_tet4([0.25, 0.3, 0.15], [0.6, 0.8, 0.2], [1, 1, 1]);
    let roof = cuboid_hex8([0.0, 0.0, 0.3], [1.0, 1.0, 0.4], [1, 2, 1]);
    Scene::new().with(&plate, 0).with(&shelf, 1).with(&roof, 1)
}
