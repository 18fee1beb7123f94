//! Where surfaces are measured, and where they are.

use std::ops::Deref;

/// Points of the straight mesh.
pub(super) struct Points<'a, const D: usize> {
    /// As surfaces are measured.
    pub(super) measured: &'a [[f64; D]],
    /// Where they are.
    pub(super) unshifted: &'a [[f64; D]],
}

impl<const D: usize> Deref for Points<'_, D> {
    type Target = [[f64; D]];

    fn deref(&self) -> &[[f64; D]] {
        self.measured
    }
}
