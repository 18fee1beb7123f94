//! Wear.

#[path = "../ranks/communicator.rs"]
mod communicator;
#[path = "../scene/scene.rs"]
mod scene;

mod account;
mod closed_form;
mod refused;
mod state;
mod surfaces;
mod volumes;

use fmc_contact::contact::Friction;
use fmc_contact::contact::PairOptions;
use fmc_contact::overlap::Partner;
use fmc_contact::{Contact, EnergyLaw, Obstacle, Options, Pose, Shape};
use fmc_shapes::{cuboid_hex8, cuboid_tet4, rectangle_quad4, second_order};
use scene::{Scene, table::exactly};

/// k of all laws here.
const STIFFNESS: f64 = 1e3;

/// K of both sides.
const WEAR: [f64; 2] = [2e-4, 3e-4];

/// Penetration; rims of this width bear less or more.
const DELTA: f64 = 1e-4;

/// The laws that wear, with friction or without.
fn laws(coefficient: f64) -> [Options; 2] {
    [EnergyLaw::depth(STIFFNESS), EnergyLaw::fiber(STIFFNESS)]
        .map(|law| Options { friction: Friction::coulomb(coefficient), ..exactly(law) })
}

/// A block, DELTA deep in a larger one: meshes that do not match.
fn in_plane() -> [Scene<2>; 2] {
    let lower = rectangle_quad4([-1.0, -0.6], [1.2, 0.0], [7, 2]);
    let upper = rectangle_quad4([-0.5, -DELTA], [0.5, 0.7 - DELTA], [4, 2]);
    [Scene::of(&[&lower, &upper]), Scene::of(&[&second_order(&lower, 8), &upper])]
}

/// The same in space.
fn in_space() -> [Scene<3>; 2] {
    let (below, above) = (([-1.0, -0.9, -0.6], [1.2, 0.8, 0.0]), ([-0.5, -0.4, -DELTA], [0.5, 0.4, 0.7 - DELTA]));
    [
        Scene::of(&[&cuboid_tet4(below.0, below.1, [4, 3, 2]), &cuboid_tet4(above.0, above.1, [2, 2, 2])]),
        Scene::of(&[&cuboid_hex8(below.0, below.1, [3, 4, 2]), &cuboid_hex8(above.0, above.1, [2, 3, 1])]),
    ]
}

/// Two bodies that wear, before their first step.
fn wearing<const D: usize>(scene: &Scene<D>, options: Options) -> Contact<D> {
    let mut contact = scene.contact(options);
    let pair = [Partner::Body(0), Partner::Body(1)];
    contact.set_pair_options(pair, Some(PairOptions::with_wear(WEAR))).expect("a pair that wears");
    contact
}

/// One body that wears on a half-space below it, before its first step.
fn on_a_plane<const D: usize>(scene: &Scene<D>, options: Options) -> Contact<D> {
    let mut contact = scene.contact(options);
    let pose = Pose::at([0.0; D]);
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose }).expect("an obstacle");
    let pair = [Partner::Body(0), Partner::Obstacle(0)];
    let own = PairOptions::with_wear([WEAR[0], 0.0]);
    contact.set_pair_options(pair, Some(own)).expect("a pair that wears");
    contact
}

/// The nodes of one mesh of a scene, or all, moved along the first and the last axis.
fn moved<const D: usize>(scene: &Scene<D>, mesh: usize, [along, up]: [f64; 2]) -> Vec<[f64; D]> {
    let mut coords = scene.coords.clone();
    for node in scene.nodes_of(mesh) {
        coords[node][0] += along;
        coords[node][D - 1] += up;
    }
    coords
}
