//! Coordinates without deformation, and nodes that follow unknowns.

use super::Host;
use super::array::{Array, checked, unless};
use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::{Hole, Layout};
use std::ptr::null_mut;

impl Host {
    pub(super) fn set_reference(&mut self, read: Layout, factor: f64, hole: Hole) {
        let mut coords = self.mesh.coords.clone();
        coords.iter_mut().step_by(self.mesh.dim).for_each(|x| *x *= factor);
        let coords = Array::new(&coords, self.mesh.dim, read);
        let view = coords.view;
        // SAFETY: as in `evaluate`.
        checked(unsafe {
            fmc_context_set_reference(self.context, unless(hole, 0, (&raw const view).cast_mut()).cast_const())
        });
        self.set_basis(factor, hole);
    }

    /// Every node between two unknowns, of which there is one more than nodes; then nodes move by themselves again.
    fn set_basis(&mut self, part: f64, hole: Hole) {
        let (n, base) = (self.mesh.node_count(), i64::from(self.options.index_base));
        let offsets: Vec<i64> = (0..=n as i64).map(|row| 2 * row + base).collect();
        let unknowns: Vec<i64> = (0..n as i64).flat_map(|row| [row + base, row + 1 + base]).collect();
        let weights: Vec<f64> = (0..n).flat_map(|_| [part, 1.0 - part]).collect();
        let (offsets, unknowns, weights) = (Guarded::new(&offsets), Guarded::new(&unknowns), Guarded::new(&weights));
        let at = |count: usize, rows: usize| {
            // SAFETY: a living context or NULL, arrays of the sizes that are said, or smaller sizes.
            checked(unsafe {
                let mut matrix = fmc_csr::default();
                assert_eq!(fmc_csr_init(&raw mut matrix), OK);
                (matrix.row_count, matrix.index_size, matrix.index_base) = (rows, 8, base as i32);
                matrix.row_offsets = offsets.ptr().cast();
                matrix.cols = unless(hole, 0, unknowns.ptr()).cast();
                matrix.values = unless(hole, 1, weights.ptr());
                fmc_context_set_basis(self.context, &raw const matrix, count)
            })
        };
        assert_ne!(at(n, n), OK, "an unknown too many");
        assert_ne!(at(n + 1, n - 1), OK, "a row too few");
        if at(n + 1, n) == OK {
            assert!(part.is_finite());
            let mut coords = self.mesh.coords.clone();
            coords.extend(vec![0.0; self.mesh.dim]);
            let coords = Array::new(&coords, self.mesh.dim, Layout::Rows);
            let forces = Array::new(&vec![0.0; (n + 1) * self.mesh.dim], self.mesh.dim, Layout::Rows);
            let (view, target) = (coords.view, forces.out());
            // SAFETY: views of as many rows as unknowns.
            checked(unsafe { fmc_context_evaluate(self.context, &raw const view, &raw const target, 0, null_mut()) });
        }
        // SAFETY: nothing is read.
        checked(unsafe { fmc_context_set_basis(self.context, std::ptr::null(), 0) });
    }
}
