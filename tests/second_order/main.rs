//! Cells of second order: the volume within their curved faces, what the nodes of a face bear, derivatives, refusals.

#[path = "../scene/scene.rs"]
mod scene;

mod basis;
mod by_facets;
mod derivatives;
mod flat;
mod fold;
mod friction;
mod lens;
mod maps;
mod refused;
mod round;
mod told;

use fmc_shapes::{
    Diagonals, Mesh, cuboid_hex8, cuboid_pyramid5, cuboid_tet4, cuboid_wedge6, rectangle_quad4, rectangle_tri3,
    second_order,
};
use scene::Scene;

/// A rectangle in cells of second order of each type.
fn rectangles(min: [f64; 2], max: [f64; 2], cells: [usize; 2]) -> Vec<Mesh<2>> {
    let (triangles, quads) =
        (rectangle_tri3(min, max, cells, Diagonals::Alternating), rectangle_quad4(min, max, cells));
    vec![second_order(&triangles, 6), second_order(&quads, 8), second_order(&quads, 9)]
}

/// A box in cells of second order of each type.
fn boxes(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Vec<Mesh<3>> {
    let hexahedra = cuboid_hex8(min, max, cells);
    vec![
        second_order(&cuboid_tet4(min, max, cells), 10),
        second_order(&hexahedra, 20),
        second_order(&hexahedra, 27),
        second_order(&cuboid_wedge6(min, max, cells), 15),
        second_order(&cuboid_pyramid5(min, max, cells), 13),
    ]
}

/// Bodies 0 and 1.
fn pair<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>) -> Scene<D> {
    Scene::of(&[lower, upper])
}

/// All nodes moved at random by up to this much.
fn shaken<const D: usize>(coords: &[[f64; D]], by: f64, seed: u64) -> Vec<[f64; D]> {
    let mut random = fmc_shapes::Splitmix::new(seed);
    coords.iter().map(|x| x.map(|x| x + random.between(-by, by))).collect()
}
