//! The equilibrium that a search found last, for the next one that begins there.

/// Where it is, and what acts there.
pub(crate) struct LastEquilibrium {
    /// Unknowns of the host.
    pub(crate) x: Vec<f64>,
    /// Its internal less external forces.
    pub(crate) inside: Vec<f64>,
    /// What every pair presses with.
    pub(crate) pressed: Vec<f64>,
    /// Forces by which its residual was measured: an end without load has none of its own.
    pub(crate) scale: f64,
}

impl LastEquilibrium {
    /// Whether this is the same place with the same forces, to the last bit.
    pub(crate) fn is(&self, x: &[f64], inside: &[f64], pressed: &[f64]) -> bool {
        self.x == x && self.inside == inside && self.pressed == pressed
    }
}
