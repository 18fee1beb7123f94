//! Friction by a law of the host: the same as the library's own, closed forms, differences, history, and refusals.

#[path = "../ranks/communicator.rs"]
mod communicator;
#[path = "../scene/scene.rs"]
mod scene;

mod checked;
mod closed_form;
mod cost;
mod derivatives;
mod laws;
mod refused;
mod repeated;
mod shared;
mod state;

use fmc_contact::contact::{FrictionLaw, PairOptions};
use fmc_contact::overlap::Partner::{self, Body, Obstacle};
use fmc_contact::{Contact, EnergyLaw, Options, Pose, Shape};
use fmc_shapes::{Mesh, cuboid_hex8, rectangle_quad4, rectangle_tri3};
use scene::{Scene, table::exactly};
use std::sync::Arc;

/// k of all laws here.
const STIFFNESS: f64 = 1e3;

/// How deep the upper body is in the lower one.
const DELTA: f64 = 1e-3;

fn depth() -> Options {
    exactly(EnergyLaw::depth(STIFFNESS))
}

/// A block on a larger one, with meshes that do not match.
fn in_plane() -> Scene<2> {
    let below = rectangle_quad4([-1.0, -0.6], [1.2, 0.0], [5, 2]);
    Scene::of(&[&below, &rectangle_tri3([-0.5, -DELTA], [0.5, 0.7 - DELTA], [3, 2], fmc_shapes::Diagonals::Same)])
}

fn in_space() -> Scene<3> {
    let below = cuboid_hex8([-1.0, -0.9, -0.6], [1.2, 0.8, 0.0], [3, 4, 2]);
    Scene::of(&[&below, &cuboid_hex8([-0.5, -0.4, -DELTA], [0.5, 0.4, 0.7 - DELTA], [2, 3, 1])])
}

/// A block of area 1 on a plane: the pressure is one and the same.
fn on_plane<const D: usize>(mesh: &Mesh<D>, options: Options) -> (Scene<D>, Contact<D>) {
    let scene = Scene::of(&[mesh]);
    let mut contact = scene.contact(options);
    let plane = fmc_contact::Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; D]) };
    contact.add_obstacle(plane).expect("a plane");
    (scene, contact)
}

fn flat_block() -> Mesh<2> {
    rectangle_quad4([0.5, -DELTA], [1.5, 0.5], [4, 2])
}

fn flat_cuboid() -> Mesh<3> {
    cuboid_hex8([0.5, 0.0, -DELTA], [1.5, 1.0, 0.5], [2, 3, 1])
}

const BODIES: [Partner; 2] = [Body(0), Body(1)];
const ON_PLANE: [Partner; 2] = [Body(0), Obstacle(0)];

fn rub<const D: usize>(contact: &mut Contact<D>, pair: [Partner; 2], law: impl FrictionLaw + 'static) {
    contact.set_friction_law_pair(pair, PairOptions::default(), Arc::new(law)).expect("a law");
}

/// The nodes of the last mesh moved alike.
fn moved<const D: usize>(scene: &Scene<D>, by: [f64; D]) -> Vec<[f64; D]> {
    let mut coords = scene.coords.clone();
    let last = scene.first_node.len() - 1;
    scene.nodes_of(last).for_each(|node| (0..D).for_each(|i| coords[node][i] += by[i]));
    coords
}

fn along<const D: usize>(scene: &Scene<D>, by: f64) -> Vec<[f64; D]> {
    moved(scene, std::array::from_fn(|i| if i == 0 { by } else { 0.0 }))
}

/// The same with all nodes a little elsewhere.
fn waved<const D: usize>(coords: &[[f64; D]], by: f64) -> Vec<[f64; D]> {
    let wave = |node: usize, axis: usize| by * (1.7 * node as f64 + 2.9 * axis as f64).sin();
    let one = |(node, x): (usize, &[f64; D])| std::array::from_fn(|axis| x[axis] + wave(node, axis));
    coords.iter().enumerate().map(one).collect()
}

/// The same along the last axis alone: walls stay upright, and do not rub.
fn waved_across<const D: usize>(coords: &[[f64; D]], by: f64) -> Vec<[f64; D]> {
    let waved = waved(coords, by);
    let one =
        |(x, y): (&[f64; D], &[f64; D])| std::array::from_fn(|axis| if axis == D - 1 { y[axis] } else { x[axis] });
    coords.iter().zip(&waved).map(one).collect()
}
