//! Bodies that are tied: they go together whatever their meshes, and bear what shape functions say.

#[path = "../scene/scene.rs"]
mod scene;

mod changed;
mod derivatives;
mod equations;
mod patches;
mod uniform;

use fmc_contact::contact::PairOptions;
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::{
    Diagonals, Mesh, cuboid_hex8, cuboid_tet4, cuboid_wedge6, rectangle_quad4, rectangle_tri3, second_order,
};
use scene::Scene;

/// Stiffness of all ties here.
const K: f64 = 100.0;

/// A rectangle in cells of each type.
fn rectangles(min: [f64; 2], max: [f64; 2], cells: [usize; 2]) -> Vec<Mesh<2>> {
    let (triangles, quads) =
        (rectangle_tri3(min, max, cells, Diagonals::Alternating), rectangle_quad4(min, max, cells));
    let curved = [second_order(&triangles, 6), second_order(&quads, 8), second_order(&quads, 9)];
    [triangles, quads].into_iter().chain(curved).collect()
}

/// A box in cells of several types.
fn boxes(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Vec<Mesh<3>> {
    let (tets, hexahedra) = (cuboid_tet4(min, max, cells), cuboid_hex8(min, max, cells));
    let curved = [second_order(&tets, 10), second_order(&hexahedra, 20), second_order(&hexahedra, 27)];
    [tets, hexahedra, cuboid_wedge6(min, max, cells)].into_iter().chain(curved).collect()
}

/// Two blocks of every pair of types, one on the other, 2 edges on 3, with a gap between them.
fn in_the_plane(gap: f64) -> Vec<Scene<2>> {
    let below = rectangles([0.0, 0.0], [1.0, 0.5], [2, 1]);
    let above = rectangles([0.0, 0.5 + gap], [1.0, 1.0], [3, 1]);
    below.iter().flat_map(|below| above.iter().map(move |above| Scene::of(&[below, above]))).collect()
}

fn in_space(gap: f64) -> Vec<Scene<3>> {
    let below = boxes([0.0, 0.0, 0.0], [1.0, 1.0, 0.5], [1, 2, 1]);
    let above = boxes([0.0, 0.0, 0.5 + gap], [1.0, 1.0, 1.0], [2, 1, 1]);
    below.iter().flat_map(|below| above.iter().map(move |above| Scene::of(&[below, above]))).collect()
}

/// The contact of a scene whose first two bodies are tied.
fn tied<const D: usize>(scene: &Scene<D>, reach: f64) -> Contact<D> {
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    contact.set_pair_options([0, 1].map(Body), Some(PairOptions::tied(reach))).expect("a tie");
    contact
}

/// The largest of some vectors.
fn largest<const D: usize>(vectors: &[[f64; D]]) -> f64 {
    vectors.iter().flatten().fold(0.0, |most, x| x.abs().max(most))
}
