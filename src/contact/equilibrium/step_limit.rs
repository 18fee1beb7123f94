//! How far a step of a host's own may go.

use super::driver::{StepLimit, step_limit};
use crate::Error;
use crate::contact::evaluation::Contact;

impl<const D: usize> Contact<D> {
    /// How far the nodes at `coords` may go along `step` so that nothing passes through anything: surfaces come to overlap by half a facet at
    /// most, beyond what they do, and no body moves by more than half its thickness against the others.
    ///
    /// # Errors
    /// [`Error::Length`] for a step of another length than the coordinates; else as [`Self::gap_constraints`].
    #[inline(never)]
    pub fn step_limit(&self, coords: &[[f64; D]], step: &[[f64; D]]) -> Result<StepLimit, Error> {
        step_limit(self, coords, step)
    }
}
