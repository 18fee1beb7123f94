//! Bodies condensed to what feels contact.

use super::status::fmc_status;

/// Opaque.
#[repr(C)]
pub struct fmc_condensation {
    _private: [u8; 0],
}

unsafe extern "C" {
    pub fn fmc_condensation_new(condensation: *mut *mut fmc_condensation) -> fmc_status;
    pub fn fmc_condensation_free(condensation: *mut *mut fmc_condensation) -> fmc_status;
    pub fn fmc_condensation_factorise(
        condensation: *mut fmc_condensation,
        count: usize,
        row_offsets: *const i64,
        cols: *const i64,
        values: *const f64,
        kept: *const i64,
        kept_count: usize,
    ) -> fmc_status;
    pub fn fmc_condensation_complement(
        condensation: *const fmc_condensation,
        complement: *mut f64,
        capacity: usize,
    ) -> fmc_status;
    pub fn fmc_condensation_condense(
        condensation: *const fmc_condensation,
        right: *const f64,
        count: usize,
        condensed: *mut f64,
        capacity: usize,
    ) -> fmc_status;
    pub fn fmc_condensation_expand(
        condensation: *const fmc_condensation,
        right: *const f64,
        count: usize,
        kept: *const f64,
        kept_count: usize,
        solution: *mut f64,
        capacity: usize,
    ) -> fmc_status;
}
