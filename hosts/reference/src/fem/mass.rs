//! Volume and lumped mass.

use super::Model;

impl<const D: usize> Model<D> {
    /// Volume (2D: area) of a part, by its Gauss points.
    pub fn volume(&self, part: usize) -> f64 {
        self.elements_of(part).iter().flat_map(|elements| &elements.volumes).sum()
    }

    /// Mass of every node, by row sum: m_a = ∫ ρ N_a dV; in cells of second order in proportion to ∫ ρ N_a² dV, with
    /// the mass of the cell in all. Positive for all cells of the model.
    pub fn lumped_mass(&self) -> Vec<f64> {
        let mut mass = vec![0.0; self.node_count()];
        for elements in &self.elements {
            for (&node, share) in elements.conn.iter().zip(&elements.lumps) {
                mass[node as usize] += elements.material.density * share;
            }
        }
        mass
    }
}
