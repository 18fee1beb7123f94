//! Stiffness.

use super::{Model, Triplets};

impl<const D: usize> Model<D> {
    /// Stiffness ∂²E/∂u² at a displacement, `[node_count, D]`: symmetric, entries cell after cell.
    pub fn tangent(&self, displacement: &[[f64; D]]) -> Triplets {
        Triplets { size: displacement.len() * D, ..Triplets::default() }
    }
}
