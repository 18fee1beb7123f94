//! Stiffness of the model.

use super::response::Response;
use super::{Model, Triplets};

impl<const D: usize> Model<D> {
    /// Stiffness ∂²E/∂u² at a displacement, `[node_count, D]`: symmetric, entries cell after cell, in the same places
    /// for every displacement.
    ///
    /// # Panics
    /// If `displacement` has another length.
    pub fn tangent(&self, displacement: &[[f64; D]]) -> Triplets {
        assert_eq!(displacement.len(), self.node_count());
        let mut triplets = Triplets { size: displacement.len() * D, ..Triplets::default() };
        let mut matrix = Vec::new();
        for elements in &self.elements {
            let response = Response::new(&elements.material);
            let count = elements.cell_type.node_count();
            for (cell, nodes) in elements.conn.chunks_exact(count).enumerate() {
                elements.stiffness(&response, cell, displacement, &mut matrix);
                let freedom = |local: usize| nodes[local / D] as usize * D + local % D;
                for (entry, &value) in matrix.iter().enumerate() {
                    triplets.push(freedom(entry / (count * D)), freedom(entry % (count * D)), value);
                }
            }
        }
        triplets
    }
}
