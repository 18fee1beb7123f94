//! Bodies condensed to what feels contact: a chain of springs, right or damaged.

use crate::guarded::Guarded;
use crate::host::{checked, unless};
use crate::interface::*;
use crate::program::Hole;
use std::ptr::null_mut;

const UNTOUCHED: f64 = -77.0;

/// Factorises a chain of springs of which one entry may be `value`, with the equations of `which` kept, and solves with it. Bits 12
/// to 15 of `which` are the number of equations; `shift` damages an offset, a column or an equation that is kept.
pub(crate) fn chain(which: u16, shift: i8, value: f64, hole: Hole) {
    let count = usize::from(which >> 12);
    let (mut offsets, mut cols, mut values) = (vec![0i64], Vec::new(), Vec::new());
    for row in 0..count as i64 {
        for (column, entry) in [(row - 1, -1.0), (row, 2.5), (row + 1, -1.0)] {
            if (0..count as i64).contains(&column) {
                cols.push(column);
                values.push(entry);
            }
        }
        offsets.push(cols.len() as i64);
    }
    let mut kept: Vec<i64> = (0..count as i64).filter(|equation| which >> equation & 1 == 1).take(12).collect();
    match which & 3 {
        0 => values.iter_mut().take(1).for_each(|entry| *entry = value),
        1 => offsets.iter_mut().skip(1).take(1).for_each(|offset| *offset += i64::from(shift)),
        2 => cols.iter_mut().take(1).for_each(|column| *column += i64::from(shift)),
        _ => kept.iter_mut().take(1).for_each(|equation| *equation += i64::from(shift)),
    }
    let mut condensation = null_mut();
    // SAFETY: a condensation of this function; the last offset is the number of columns and values, since there are two
    // or more where one is damaged, or it is refused as a length.
    unsafe {
        assert_eq!(checked(fmc_condensation_new(&raw mut condensation)), OK);
        let given = (Guarded::new(&offsets), Guarded::new(&cols), Guarded::new(&values), Guarded::new(&kept));
        // A single row's damaged offset would be the length of its arrays.
        if count != 1 || which & 3 != 1 {
            let mut matrix = fmc_csr::default();
            assert_eq!(checked(fmc_csr_init(&raw mut matrix)), OK);
            (matrix.row_count, matrix.index_size) = (count, 8);
            matrix.row_offsets = unless(hole, 0, given.0.ptr()).cast();
            matrix.cols = unless(hole, 1, given.1.ptr()).cast();
            matrix.values = unless(hole, 2, given.2.ptr());
            let retained = unless(hole, 3, given.3.ptr()).cast();
            checked(fmc_condensation_factorise(condensation, &raw const matrix, retained, kept.len()));
        }
        solve(condensation, count, kept.len(), value, hole);
        assert_eq!(checked(fmc_condensation_free(&raw mut condensation)), OK);
        assert!(condensation.is_null());
    }
}

/// # Safety
/// A living condensation.
unsafe fn solve(condensation: *const fmc_condensation, count: usize, kept: usize, value: f64, hole: Hole) {
    let numbers = |length: usize, number: f64| Guarded::new(&vec![number; length]);
    let (right, at_kept) = (numbers(count, value), numbers(kept, 0.5));
    let found = [kept * kept, kept, count].map(|length| numbers(length, UNTOUCHED));
    // SAFETY: arrays of the lengths that are said; the condensation by the caller.
    let status = unsafe {
        [
            fmc_condensation_complement(condensation, unless(hole, 4, found[0].ptr()), kept * kept, null_mut()),
            fmc_condensation_condense(
                condensation,
                unless(hole, 5, right.ptr()),
                count,
                found[1].ptr(),
                kept,
                null_mut(),
            ),
            fmc_condensation_expand(
                condensation,
                unless(hole, 5, right.ptr()),
                count,
                unless(hole, 6, at_kept.ptr()),
                kept,
                unless(hole, 7, found[2].ptr()),
                count,
                null_mut(),
            ),
        ]
    };
    for (status, found) in status.into_iter().zip(&found) {
        let is_done = checked(status) == OK;
        assert!(found.values().iter().all(|number| if is_done { number.is_finite() } else { *number == UNTOUCHED }));
    }
}
