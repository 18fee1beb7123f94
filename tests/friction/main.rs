//! Friction.

#[path = "../scene/scene.rs"]
mod scene;

mod derivatives;
mod fields;
mod frozen;
mod impact;
mod limits;
mod memoryless;
mod moved_out;
mod orthotropic;
mod rings;
mod side_state;
mod slip_gradients;
mod steps;
mod stick_slip;
mod stiffened;
mod touch;
mod turned;
mod volume_law;

use fmc_contact::contact::Friction;
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3};
use scene::{Scene, table::exactly};

/// k of all laws here.
const STIFFNESS: f64 = 1e3;

/// The laws with friction, exactly integrated.
fn laws(coefficient: f64) -> [Options; 2] {
    [EnergyLaw::depth(STIFFNESS), EnergyLaw::fiber(STIFFNESS)]
        .map(|law| Options { friction: Friction::coulomb(coefficient), ..exactly(law) })
}

/// A block on a larger one, `delta` deep in it: meshes that do not match, of two kinds.
fn in_plane(delta: f64) -> [Scene<2>; 2] {
    let (below, above) = (([-1.0, -0.6], [1.2, 0.0]), ([-0.5, -delta], [0.5, 0.7 - delta]));
    let of = |lower: Mesh<2>, upper: Mesh<2>| Scene::of(&[&lower, &upper]);
    [
        of(
            rectangle_tri3(below.0, below.1, [7, 2], Diagonals::Alternating),
            rectangle_tri3(above.0, above.1, [3, 2], Diagonals::Same),
        ),
        of(rectangle_quad4(below.0, below.1, [5, 2]), rectangle_quad4(above.0, above.1, [4, 2])),
    ]
}

/// The same in space.
fn in_space(delta: f64) -> [Scene<3>; 2] {
    let (below, above) = (([-1.0, -0.9, -0.6], [1.2, 0.8, 0.0]), ([-0.5, -0.4, -delta], [0.5, 0.4, 0.7 - delta]));
    let of = |lower: Mesh<3>, upper: Mesh<3>| Scene::of(&[&lower, &upper]);
    [
        of(cuboid_tet4(below.0, below.1, [4, 3, 2]), cuboid_tet4(above.0, above.1, [2, 2, 2])),
        of(cuboid_hex8(below.0, below.1, [3, 4, 2]), cuboid_hex8(above.0, above.1, [2, 3, 1])),
    ]
}

/// A contact whose first step begins at these coordinates.
fn begun<const D: usize>(scene: &Scene<D>, options: Options, coords: &[[f64; D]]) -> Contact<D> {
    let mut contact = scene.contact(options);
    contact.begin_step(coords).expect("valid coordinates");
    contact
}

/// The nodes of one mesh of a scene moved.
fn moved<const D: usize>(scene: &Scene<D>, mesh: usize, by: impl Fn([f64; D]) -> [f64; D]) -> Vec<[f64; D]> {
    let mut coords = scene.coords.clone();
    scene.nodes_of(mesh).for_each(|node| coords[node] = by(coords[node]));
    coords
}

/// The upper block shifted along the first axis.
fn slid<const D: usize>(scene: &Scene<D>, by: f64) -> Vec<[f64; D]> {
    moved(scene, 1, |mut x| {
        x[0] += by;
        x
    })
}

/// The upper block raised along the last axis.
fn raised<const D: usize>(scene: &Scene<D>, by: f64) -> Vec<[f64; D]> {
    moved(scene, 1, |mut x| {
        x[D - 1] += by;
        x
    })
}
