//! The equilibrium that a search found last, for the next one that begins there.

use crate::contact::partners::Poses;

/// Where it is, and what acts there.
pub(crate) struct LastEquilibrium<const D: usize> {
    /// Unknowns of the host.
    pub(crate) x: Vec<f64>,
    /// Its internal less external forces.
    pub(crate) inside: Vec<f64>,
    /// What every pair presses with.
    pub(crate) pressed: Vec<f64>,
    /// Where the obstacles stand.
    pub(crate) poses: Poses<D>,
    /// Forces by which its residual was measured: an end without load has none of its own.
    pub(crate) scale: f64,
}

impl<const D: usize> LastEquilibrium<D> {
    /// Whether this is the same place with the same forces, to the last bit.
    pub(crate) fn is(&self, x: &[f64], inside: &[f64], pressed: &[f64], poses: &Poses<D>) -> bool {
        self.x == x && self.inside == inside && self.pressed == pressed && self.poses == *poses
    }
}
