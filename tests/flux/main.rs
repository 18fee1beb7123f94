//! Heat through contact: against closed forms, and what every flux has.

#[path = "../scene/scene.rs"]
mod scene;

mod accuracy;
mod bars;
mod friction_heat;
mod obstacles;
mod properties;
mod refused;
mod ties;

use fmc_contact::contact::{Conductance, ContactFlux, FluxRequest};
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::{
    Diagonals, Mesh, cuboid_hex8, cuboid_tet4, cuboid_wedge6, rectangle_quad4, rectangle_tri3, second_order,
};
use scene::Scene;

/// Stiffness of all contacts here.
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

/// Two blocks of every pair of types, one on the other, 2 edges on 3, with a gap between them; where negative they overlap.
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

fn pressed<const D: usize>(scene: &Scene<D>) -> Contact<D> {
    scene.contact(Options::new(EnergyLaw::depth(K)))
}

/// The flux of one field without obstacles.
fn flux<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], field: &[f64], h: &Conductance) -> ContactFlux {
    contact.flux(coords, &FluxRequest { fields: field, of_obstacles: None, conductance: h }).expect("a flux")
}

/// A field by place and mesh.
fn field<const D: usize>(scene: &Scene<D>, value: impl Fn(usize, &[f64; D]) -> f64) -> Vec<f64> {
    let of_mesh = |mesh: usize| scene.nodes_of(mesh).map(move |node| (mesh, node));
    (0..scene.first_node.len()).flat_map(of_mesh).map(|(mesh, node)| value(mesh, &scene.coords[node])).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The largest of some numbers.
fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, x| x.abs().max(most))
}

/// The sum of the flux out of the nodes of a mesh.
fn out_of<const D: usize>(scene: &Scene<D>, found: &ContactFlux, mesh: usize) -> f64 {
    found.flux[scene.nodes_of(mesh)].iter().sum()
}
