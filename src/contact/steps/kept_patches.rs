//! Patches of a local law, kept during a solve.

use crate::Error;
use crate::contact::evaluation::kernels;
use crate::contact::interface::Contact;

impl<const D: usize> Contact<D> {
    /// Finds the patches of the fiber law at `coords` and keeps them, that is the directions and the spacing of their
    /// lines, for all later evaluations, until this is called again or [`Self::release_patches`]. With kept patches the
    /// forces are the gradient of one energy, as a Newton solver needs. Patches of pairs that do not overlap at
    /// `coords` are not kept, but found at every evaluation. Returns the number of directions kept; 0 for other laws.
    ///
    /// # Errors
    /// As [`Self::evaluate`]; patches kept before are then still kept.
    pub fn keep_patches(&mut self, coords: &[[f64; D]]) -> Result<usize, Error> {
        self.check_brought(coords)?;
        self.kept = kernels::patches(self, coords)?;
        self.turns.kept = (self.turn(), self.poses());
        Ok(self.kept.iter().map(|(_, patches)| patches.directions.len()).sum())
    }

    /// Releases kept patches.
    pub fn release_patches(&mut self) {
        self.kept.clear();
    }
}
