//! Bodies that slide and do not separate, and those that separate and do not slide.

#[path = "../scene/blocks.rs"]
mod blocks;
#[path = "../scene/scene.rs"]
mod scene;

mod derivatives;
mod held;
mod pin;
mod rough;

use blocks::{in_space, in_the_plane};
use fmc_contact::contact::PairOptions;
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Options};
use scene::Scene;

/// Stiffness of all pairs here.
const K: f64 = 100.0;

/// The contact of a scene whose first two bodies have these options.
fn with<const D: usize>(scene: &Scene<D>, options: PairOptions) -> Contact<D> {
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    contact.set_pair_options([0, 1].map(Body), Some(options)).expect("options of a pair");
    contact
}

fn sliding<const D: usize>(scene: &Scene<D>, reach: f64) -> Contact<D> {
    with(scene, PairOptions::no_separation(reach))
}

/// The second body moved by a vector.
fn shifted<const D: usize>(scene: &Scene<D>, by: [f64; D]) -> Vec<[f64; D]> {
    let mut coords = scene.coords.clone();
    coords[scene.first_node[1]..].iter_mut().for_each(|x| (0..D).for_each(|axis| x[axis] += by[axis]));
    coords
}

/// Blocks in space, of every type below and above.
fn some_in_space(gap: f64) -> Vec<Scene<3>> {
    in_space(gap).into_iter().step_by(5).collect()
}

/// The largest of some vectors.
fn largest<const D: usize>(vectors: &[[f64; D]]) -> f64 {
    vectors.iter().flatten().fold(0.0, |most, x| x.abs().max(most))
}
