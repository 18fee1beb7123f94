//! Incompatible modes, by which quadrilaterals and hexahedra of first order bend without locking.
//!
//! With ξ in [−1, 1]ᴰ, J = ∂X/∂ξ with the determinant j, and J₀, j₀ those of the centre:
//!
//! ```text
//! H   = Σ u_a ⊗ ∇N_a + Σ α_m ⊗ g_m,    g_m = j₀/j J₀^(−T) ∂(1 − ξ_m²)/∂ξ
//! α   = those of least energy = A u     (linear laws alone)
//! ```
//!
//! Bubbles 1 − ξ_m² of each axis: Wilson, Taylor, Doherty and Ghaboussi, "Incompatible displacement models" (1973). Slopes by the centre, so
//! that ∫ g_m dV = 0 and uniform stress is met in distorted cells: Taylor, Beresford and Wilson, "A non-conforming element for stress
//! analysis" (1976). Since the energy is least, the force is ∫ P ∇N_a dV as without modes, at this H.

use super::tensor::{Tensor, from_fn};

/// Modes of the cells of one type of a part.
#[derive(Debug)]
pub(super) struct Modes<const D: usize> {
    /// g_m at each Gauss point, `[cell_count, point_count, D]`; zero in cells without modes.
    pub(super) slopes: Vec<[[f64; D]; D]>,
    /// A of each cell by rows: mode · D + axis, node · D + axis.
    pub(super) amplitudes: Vec<f64>,
}

impl<const D: usize> Modes<D> {
    /// α of a cell at the displacements of its nodes.
    pub(super) fn amplitudes(&self, cell: usize, u: &[[f64; D]]) -> Tensor<D> {
        let size = u.len() * D;
        let rows = &self.amplitudes[cell * D * D * size..][..D * D * size];
        from_fn(|mode, axis| {
            let row = &rows[(mode * D + axis) * size..][..size];
            row.iter().zip(u.as_flattened()).map(|(a, u)| a * u).sum()
        })
    }

    /// What modes add to H at a Gauss point, counted over all cells.
    #[inline(always)]
    pub(super) fn add(&self, point: usize, amplitudes: &Tensor<D>, h: &mut Tensor<D>) {
        for (alpha, slope) in amplitudes.iter().zip(&self.slopes[point]) {
            (0..D).for_each(|i| (0..D).for_each(|j| h[i][j] += alpha[i] * slope[j]));
        }
    }
}
