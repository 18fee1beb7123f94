//! Largest eigenfrequency, which bounds the step of explicit integration.

use super::Model;
use super::elements::Elements;
use super::response::Response;
use fmc_contact::contact::{Accuracy, largest_eigenvalue};
use fmc_shapes::Splitmix;
use nalgebra::DMatrix;
use rayon::prelude::*;

/// Lanczos' iteration ends when the residual of the Ritz vector is this part of its value: the frequency, its root, is then
/// known to half of that. Smaller values cost steps (about the inverse root of it) and no time step is longer by them.
const RESIDUAL: f64 = 1e-3;

impl<const D: usize> Model<D> {
    /// Largest eigenfrequency ω at a displacement, in rad/s: an upper estimate, within 0.1 %, of the root of the largest
    /// eigenvalue of M⁻¹K, M diagonal with `mass` per node. The leapfrog is stable for steps below 2/ω.
    ///
    /// Lanczos' iteration gives the estimate; where it does not converge, [`Model::frequency_bound`] stands in.
    ///
    /// # Panics
    /// If an array has another length than [`Model::node_count`].
    pub fn largest_frequency(&self, displacement: &[[f64; D]], mass: &[f64]) -> f64 {
        assert_eq!([displacement.len(), mass.len()], [self.node_count(); 2]);
        // M^(−1/2) K M^(−1/2) has the same eigenvalues and is symmetric.
        let scale: Vec<f64> = mass.iter().map(|mass| 1.0 / mass.sqrt()).collect();
        let mut product = vec![[0.0; D]; mass.len()];
        let scaled =
            |x: &[[f64; D]]| -> Vec<[f64; D]> { x.iter().zip(&scale).map(|(x, scale)| x.map(|x| scale * x)).collect() };
        let mut random = Splitmix::new(0);
        let start = mass.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        let estimate = largest_eigenvalue(start, Accuracy::Residual(RESIDUAL), |x| {
            self.stiffness_product(displacement, &scaled(x), &mut product);
            scaled(&product)
        });
        match estimate {
            Some(eigenvalue) => eigenvalue.max(0.0).sqrt(),
            None => self.frequency_bound(displacement, mass),
        }
    }

    /// Bound of the same from single elements, by Rayleigh's quotient: xᵀKx / xᵀMx ≤ max over the elements of
    /// xᵀK_e x / xᵀM_e x if ΣM_e = M. `mass` at each node is divided in proportion to the elements' shares of it.
    /// Sharp on meshes of equal cells; a third above the estimate on the star, twice on badly distorted meshes.
    ///
    /// # Panics
    /// If an array has another length than [`Model::node_count`].
    pub fn frequency_bound(&self, displacement: &[[f64; D]], mass: &[f64]) -> f64 {
        assert_eq!([displacement.len(), mass.len()], [self.node_count(); 2]);
        let lumped = self.lumped_mass();
        let added: Vec<f64> = mass.iter().zip(&lumped).map(|(mass, lumped)| mass / lumped).collect();
        let bound = |elements: &Elements<D>| {
            let cells = 0..elements.len();
            let eigenvalue = |cell: usize| cell_eigenvalue(elements, cell, displacement, &added);
            match &self.pool {
                None => cells.map(eigenvalue).fold(0.0, f64::max),
                Some(pool) => pool.install(|| cells.into_par_iter().map(eigenvalue).reduce(|| 0.0, f64::max)),
            }
        };
        self.elements.iter().map(bound).fold(0.0, f64::max).sqrt()
    }
}

/// Largest eigenvalue of one element with its share of the nodes' masses, times `added`.
fn cell_eigenvalue<const D: usize>(
    elements: &Elements<D>,
    cell: usize,
    displacement: &[[f64; D]],
    added: &[f64],
) -> f64 {
    let count = elements.cell_type.node_count();
    let nodes = &elements.conn[cell * count..][..count];
    let shares = &elements.lumps[cell * count..][..count];
    let scale: Vec<f64> = nodes
        .iter()
        .zip(shares)
        .map(|(&node, share)| 1.0 / (elements.material.density * share * added[node as usize]).sqrt())
        .collect();
    let mut matrix = Vec::new();
    elements.stiffness(&Response::new(&elements.material), cell, displacement, &mut matrix);
    let matrix = DMatrix::from_vec(count * D, count * D, matrix);
    matrix.map_with_location(|row, column, k| scale[row / D] * k * scale[column / D]).symmetric_eigenvalues().max()
}
