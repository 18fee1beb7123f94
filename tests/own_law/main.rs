//! Interfaces that follow a law of the host: the same as the library's own law, closed forms, differences, history, and refusals.

#[path = "../ranks/communicator.rs"]
mod communicator;
#[path = "../scene/scene.rs"]
mod scene;

mod bilinear;
mod checked;
mod closed_form;
mod cost;
mod derivatives;
mod laws;
mod refused;
mod shared;

use fmc_contact::contact::{Interface, InterfaceLaw, PairOptions};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::{cuboid_hex8, cuboid_tet4, rectangle_quad4, second_order};
use scene::Scene;
use std::sync::Arc;

fn options() -> PairOptions {
    PairOptions { interface: Interface::Law { reach: 0.1 }, ..PairOptions::default() }
}

fn held<const D: usize>(scene: &Scene<D>, law: impl InterfaceLaw + 'static) -> Contact<D> {
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(1.0)));
    contact.set_law_pair([Body(0), Body(1)], options(), Arc::new(law)).expect("an interface");
    contact
}

/// Two blocks of width 1 and height 1/2, one above the other, with meshes that do not match, of first and of second order.
fn in_the_plane(gap: f64) -> Vec<Scene<2>> {
    let below = rectangle_quad4([0.0, 0.0], [1.0, 0.5], [2, 1]);
    let above = rectangle_quad4([0.0, 0.5 + gap], [1.0, 1.0 + gap], [3, 1]);
    vec![Scene::of(&[&below, &above]), Scene::of(&[&second_order(&below, 9), &second_order(&above, 8)])]
}

fn in_space(gap: f64) -> Vec<Scene<3>> {
    let below = cuboid_hex8([0.0; 3], [1.0, 1.0, 0.5], [2, 1, 1]);
    let (from, to) = ([0.0, 0.0, 0.5 + gap], [1.0, 1.0, 1.0 + gap]);
    let above = cuboid_hex8(from, to, [1, 2, 1]);
    let tets = cuboid_tet4(from, to, [1, 1, 1]);
    vec![
        Scene::of(&[&below, &above]),
        Scene::of(&[&second_order(&below, 27), &above]),
        Scene::of(&[&below, &second_order(&tets, 10)]),
    ]
}

fn field<const D: usize>(coords: &[[f64; D]], seed: f64) -> Vec<[f64; D]> {
    let wave = |node: usize, axis: usize| (seed + 1.7 * node as f64 + 2.9 * axis as f64).sin();
    (0..coords.len()).map(|node| std::array::from_fn(|axis| wave(node, axis))).collect()
}

fn plus<const D: usize>(coords: &[[f64; D]], by: f64, step: &[[f64; D]]) -> Vec<[f64; D]> {
    coords.iter().zip(step).map(|(x, d)| std::array::from_fn(|axis| x[axis] + by * d[axis])).collect()
}

/// Deformed by a wave.
fn waved<const D: usize>(scene: &Scene<D>, by: f64, seed: f64) -> Vec<[f64; D]> {
    plus(&scene.coords, by, &field(&scene.coords, seed))
}

/// The nodes of the second body moved.
fn moved<const D: usize>(scene: &Scene<D>, by: [f64; D]) -> Vec<[f64; D]> {
    let start = scene.first_node[1];
    let moved = |(node, x): (usize, &[f64; D])| std::array::from_fn(|i| x[i] + if node >= start { by[i] } else { 0.0 });
    scene.coords.iter().enumerate().map(moved).collect()
}

fn largest<const D: usize>(rows: &[[f64; D]]) -> f64 {
    rows.iter().flatten().fold(0.0, |most, x| most.max(x.abs()))
}
