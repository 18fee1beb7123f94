//! The tangent, as entries and in compressed rows.

use super::Host;
use super::array::{Array, CANARY, checked, unless};
use super::evaluation::no_result;
use super::numbers::Numbers;
use crate::guarded::Guarded;
use crate::interface::*;
use crate::program::{Hole, Layout};
use std::ptr::null_mut;

impl Host {
    pub(super) fn tangent(&mut self, read: Layout, flags: u8, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, read);
        let (mut entry_count, mut rank_one_count) = (77usize, 77usize);
        let view = coords.view;
        // SAFETY: as in `evaluate`; entries go where there is room for so many.
        unsafe {
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let status =
                checked(fmc_context_tangent(self.context, coords, u32::from(flags % 4), &raw mut rank_one_count));
            if status != OK {
                assert_eq!(rank_one_count, 77);
                return;
            }
            let none = null_mut();
            let count = unless(hole, 1, &raw mut entry_count);
            assert_eq!(checked(fmc_context_tangent_entries(self.context, none, none, null_mut(), 0, count)), OK);
            if hole == 2 {
                return;
            }
            if count.is_null() {
                return;
            }
            let list = || Numbers::new(&vec![-1; entry_count], self.is_wide);
            let (rows, cols) = (list(), list());
            let values = Guarded::new(&vec![f64::from_bits(CANARY); entry_count]);
            let give = |room| {
                let (rows, cols) = (rows.ptr(), cols.ptr());
                checked(fmc_context_tangent_entries(self.context, rows, cols, values.ptr(), room, null_mut()))
            };
            assert!(entry_count == 0 || give(entry_count - 1) != OK, "room for too few");
            assert_eq!(give(entry_count), OK);
            // Whether they are finite is not asked: entries of bodies of any shape may leave the range.
            let base = i64::from(self.options.index_base);
            assert!(rows.values().iter().chain(&cols.values()).all(|&at| at >= base));
            assert!(values.values().iter().all(|v| v.to_bits() != CANARY));
            let length = self.mesh.coords.len();
            let x = Guarded::new(&vec![1.0; length]);
            assert_eq!(checked(fmc_context_tangent_product(self.context, x.ptr(), x.ptr(), length)), OK);
            let mut factor = 0.0;
            for index in 0..=rank_one_count {
                let status = fmc_context_tangent_rank_one(self.context, index, &raw mut factor, x.ptr(), length);
                assert!(checked(status) != OK || index < rank_one_count);
            }
        }
    }

    /// Forces and tangent in one call, and the tangent in compressed rows.
    pub(super) fn rows(&mut self, read: Layout, flags: u8, hole: Hole) {
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, read);
        let forces = Array::new(&vec![0.0; self.mesh.coords.len()], self.mesh.dim, Layout::Rows);
        let (mut result, mut parts) = (no_result(), 77usize);
        let (view, forces_view, dim) = (coords.view, forces.out(), self.mesh.dim);
        // SAFETY: as in `tangent`.
        unsafe {
            let coords = unless(hole, 0, (&raw const view).cast_mut());
            let forces = unless(hole, 1, (&raw const forces_view).cast_mut());
            let both = u32::from(flags % 8);
            let result = unless(hole, 2, &raw mut result);
            let status = fmc_context_evaluate_tangent(self.context, coords, both, forces, result, &raw mut parts);
            assert!(checked(status) == OK || parts == 77);
            let flags = u32::from(flags >> 3) << 2;
            let (mut offset_count, mut count) = (0usize, 0usize);
            let (offsets_at, count_at) = (&raw mut offset_count, &raw mut count);
            let (none, no_values) = (null_mut(), null_mut());
            let sizes = fmc_context_tangent_csr(self.context, flags, none, 0, offsets_at, none, no_values, 0, count_at);
            if checked(sizes) != OK {
                assert!(flags & !12 != 0);
                return;
            }
            let row_count = offset_count - 1;
            let numbers = count * if flags & FMC_CSR_BLOCKS as u32 != 0 { dim * dim } else { 1 };
            let list = |length: usize| Numbers::new(&vec![-1; length], self.is_wide);
            let (offsets, cols) = (list(offset_count), list(count));
            let values = Guarded::new(&vec![f64::from_bits(CANARY); numbers]);
            let give = |rows: usize, room: usize| {
                let (to, cols, values, none) = (offsets.ptr(), cols.ptr(), values.ptr(), null_mut());
                checked(fmc_context_tangent_csr(self.context, flags, to, rows, none, cols, values, room, none))
            };
            assert_ne!(give(row_count, count), OK, "room for too few");
            assert!(count == 0 || give(offset_count, count - 1) != OK, "room for too few");
            assert!(offsets.values().iter().chain(&cols.values()).all(|&at| at == -1));
            assert_eq!(give(offset_count, count), OK);
            assert!(values.values().iter().all(|value| value.to_bits() != CANARY));
            let base = i64::from(self.options.index_base);
            let (offsets, cols) = (offsets.values(), cols.values());
            assert!(offsets[0] == base && offsets[row_count] == count as i64 + base);
            for row in offsets.windows(2) {
                let cols = &cols[(row[0] - base) as usize..(row[1] - base) as usize];
                assert!(
                    cols.is_sorted_by(|a, b| a < b)
                        && cols.iter().all(|col| (base..row_count as i64 + base).contains(col))
                );
            }
        }
    }
}
