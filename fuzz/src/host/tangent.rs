//! The tangent, as entries and in compressed rows.

use super::Host;
use super::array::{Array, CANARY, checked, unless};
use super::evaluation::no_result;
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
            let entries = unless(hole, 1, &raw mut entry_count);
            let flags = u32::from(flags % 4);
            let status = checked(fmc_context_tangent(self.context, coords, flags, entries, &raw mut rank_one_count));
            if status != OK {
                assert_eq!((entry_count, rank_one_count), (77, 77));
                return;
            }
            if hole == 2 {
                return;
            }
            let rows = Guarded::new(&vec![-1; entry_count]);
            let cols = Guarded::new(&vec![-1; entry_count]);
            let values = Guarded::new(&vec![f64::from_bits(CANARY); entry_count]);
            assert_eq!(
                checked(fmc_context_tangent_entries(self.context, rows.ptr(), cols.ptr(), values.ptr(), entry_count)),
                OK
            );
            // Whether they are finite is not asked: entries of bodies of any shape may leave the range.
            assert!(rows.values().iter().chain(&cols.values()).all(|&at| at >= 0));
            assert!(values.values().iter().all(|v| v.to_bits() != CANARY));
            if entry_count > 0 {
                let few = entry_count - 1;
                let status = fmc_context_tangent_entries(self.context, rows.ptr(), cols.ptr(), values.ptr(), few);
                assert_ne!(checked(status), OK, "room for too few");
            }
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

    /// Forces and tangent in one call, and the tangent in compressed rows of either width.
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
            let status =
                fmc_context_evaluate_tangent(self.context, coords, both, forces, result, null_mut(), &raw mut parts);
            assert!(checked(status) == OK || parts == 77);
            let flags = u32::from(flags >> 3) << 2;
            let (mut row_count, mut count) = (0usize, 0usize);
            let sizes = (&raw mut row_count, &raw mut count);
            if checked(fmc_context_tangent_csr_size(self.context, flags, sizes.0, sizes.1)) != OK {
                assert!(flags & !28 != 0);
                return;
            }
            let numbers = count * if flags & 4 != 0 { dim * dim } else { 1 };
            let (offsets, cols) = (Guarded::new(&vec![-1i32; row_count + 1]), Guarded::new(&vec![-1i32; count]));
            let (wide, wide_cols) = (Guarded::new(&vec![-1i64; row_count + 1]), Guarded::new(&vec![-1i64; count]));
            let values = [0, 1].map(|_| Guarded::new(&vec![f64::from_bits(CANARY); numbers]));
            let [first, second] = [values[0].ptr(), values[1].ptr()];
            if count > 0 {
                let few = count - 1;
                let status = fmc_context_tangent_csr(self.context, flags, offsets.ptr(), cols.ptr(), first, few);
                assert_ne!(checked(status), OK, "room for too few");
                assert!(offsets.values().iter().chain(&cols.values()).all(|&at| at == -1));
            }
            let status = fmc_context_tangent_csr(self.context, flags, offsets.ptr(), cols.ptr(), first, count);
            assert_eq!(checked(status), OK);
            let status = fmc_context_tangent_csr_i64(self.context, flags, wide.ptr(), wide_cols.ptr(), second, count);
            assert_eq!(checked(status), OK);
            let widened = |narrow: &Guarded<i32>| narrow.values().into_iter().map(i64::from).collect::<Vec<_>>();
            assert!(widened(&offsets) == wide.values() && widened(&cols) == wide_cols.values());
            let bits = |values: &Guarded<f64>| values.values().into_iter().map(f64::to_bits).collect::<Vec<_>>();
            assert!(bits(&values[0]) == bits(&values[1]) && !bits(&values[0]).contains(&CANARY));
            let base = i64::from(flags & 16 != 0);
            let (wide, cols) = (wide.values(), wide_cols.values());
            assert!(wide[0] == base && wide[row_count] == count as i64 + base);
            for row in wide.windows(2) {
                let cols = &cols[(row[0] - base) as usize..(row[1] - base) as usize];
                assert!(
                    cols.is_sorted_by(|a, b| a < b)
                        && cols.iter().all(|col| (base..row_count as i64 + base).contains(col))
                );
            }
        }
    }
}
