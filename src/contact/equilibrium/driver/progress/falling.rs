//! What is known of a load that falls.

use crate::contact::equilibrium::augmentation::AllMultipliers;

/// A load that falls.
pub(crate) struct Falling<const D: usize> {
    /// What is left of it.
    pub(crate) part: f64,
    /// Forces of the contact with the load as it was.
    pub(crate) forces: f64,
    /// Multipliers of the load as it was.
    pub(crate) before: AllMultipliers<D>,
}
