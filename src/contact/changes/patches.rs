//! Patches of a local law, kept during a solve.

use crate::Error;
use crate::contact::evaluation::{Contact, kernels};
use crate::contact::history::KeptPatches;

/// Finds the patches at these coordinates and keeps them; returns the number of their directions.
pub(crate) fn keep<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]]) -> Result<usize, Error> {
    contact.mesh.check_brought(coords)?;
    let by_pair = kernels::patches(contact, coords)?;
    contact.history.patches = KeptPatches::new(by_pair, contact.mesh.epoch(), contact.partners.obstacles.poses());
    Ok(contact.history.patches.direction_count())
}
