//! Heat through contact: against closed forms, and what every flux has.

#[path = "../scene/blocks.rs"]
mod blocks;
#[path = "../scene/scene.rs"]
mod scene;
#[path = "../scene/thin.rs"]
mod thin_bodies;

mod accuracy;
mod bars;
mod friction_heat;
mod obstacles;
mod properties;
mod refused;
mod thin;
mod ties;

use blocks::{in_space, in_the_plane};
use fmc_contact::contact::{Conductance, ContactFlux, FluxRequest};
use fmc_contact::{Contact, EnergyLaw, Options};
use scene::Scene;

/// Stiffness of all contacts here.
const K: f64 = 100.0;

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
