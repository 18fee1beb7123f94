//! Two blocks, one on the other, of every pair of types of cells, with meshes that do not match.

use crate::scene::Scene;
use fmc_shapes::{
    Diagonals, Mesh, cuboid_hex8, cuboid_tet4, cuboid_wedge6, rectangle_quad4, rectangle_tri3, second_order,
};

/// A rectangle in cells of each type.
pub(crate) fn rectangles(min: [f64; 2], max: [f64; 2], cells: [usize; 2]) -> Vec<Mesh<2>> {
    let (triangles, quads) =
        (rectangle_tri3(min, max, cells, Diagonals::Alternating), rectangle_quad4(min, max, cells));
    let curved = [second_order(&triangles, 6), second_order(&quads, 8), second_order(&quads, 9)];
    [triangles, quads].into_iter().chain(curved).collect()
}

/// A box in cells of several types.
pub(crate) fn boxes(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Vec<Mesh<3>> {
    let (tets, hexahedra) = (cuboid_tet4(min, max, cells), cuboid_hex8(min, max, cells));
    let curved = [second_order(&tets, 10), second_order(&hexahedra, 20), second_order(&hexahedra, 27)];
    [tets, hexahedra, cuboid_wedge6(min, max, cells)].into_iter().chain(curved).collect()
}

/// Two blocks of every pair of types, one on the other, 2 edges on 3, with a gap between them; where negative they overlap.
pub(crate) fn in_the_plane(gap: f64) -> Vec<Scene<2>> {
    let below = rectangles([0.0, 0.0], [1.0, 0.5], [2, 1]);
    let above = rectangles([0.0, 0.5 + gap], [1.0, 1.0], [3, 1]);
    below.iter().flat_map(|below| above.iter().map(move |above| Scene::of(&[below, above]))).collect()
}

pub(crate) fn in_space(gap: f64) -> Vec<Scene<3>> {
    let below = boxes([0.0, 0.0, 0.0], [1.0, 1.0, 0.5], [1, 2, 1]);
    let above = boxes([0.0, 0.0, 0.5 + gap], [1.0, 1.0, 1.0], [2, 1, 1]);
    below.iter().flat_map(|below| above.iter().map(move |above| Scene::of(&[below, above]))).collect()
}
