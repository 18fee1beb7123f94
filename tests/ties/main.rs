//! Bodies that are tied: they go together whatever their meshes, and bear what shape functions say.

#[path = "../scene/blocks.rs"]
mod blocks;
#[path = "../scene/scene.rs"]
mod scene;
#[path = "../scene/thin.rs"]
mod thin_bodies;

mod added;
mod changed;
mod derivatives;
mod equations;
mod patches;
mod surfaces;
mod thin;
mod uniform;

use blocks::{in_space, in_the_plane};
use fmc_contact::contact::PairOptions;
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Options};
use scene::Scene;

/// Stiffness of all ties here.
const K: f64 = 100.0;

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
