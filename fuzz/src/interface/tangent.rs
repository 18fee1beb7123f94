//! The tangent.

use super::mesh::{fmc_context, fmc_view};
use super::status::fmc_status;

unsafe extern "C" {
    pub fn fmc_context_tangent(
        context: *mut fmc_context,
        coords: *const fmc_view,
        flags: u32,
        entry_count: *mut usize,
        rank_one_count: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_tangent_entries(
        context: *const fmc_context,
        rows: *mut i32,
        cols: *mut i32,
        values: *mut f64,
        capacity: usize,
    ) -> fmc_status;
    pub fn fmc_context_tangent_product(
        context: *const fmc_context,
        x: *const f64,
        y: *mut f64,
        length: usize,
    ) -> fmc_status;
    pub fn fmc_context_tangent_rank_one(
        context: *const fmc_context,
        index: usize,
        factor: *mut f64,
        vector: *mut f64,
        length: usize,
    ) -> fmc_status;
    pub fn fmc_context_tangent_csr_size(
        context: *const fmc_context,
        flags: u32,
        row_count: *mut usize,
        entry_count: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_tangent_csr(
        context: *const fmc_context,
        flags: u32,
        row_offsets: *mut i32,
        cols: *mut i32,
        values: *mut f64,
        capacity: usize,
    ) -> fmc_status;
    pub fn fmc_context_tangent_csr_i64(
        context: *const fmc_context,
        flags: u32,
        row_offsets: *mut i64,
        cols: *mut i64,
        values: *mut f64,
        capacity: usize,
    ) -> fmc_status;
    pub fn fmc_context_set_obstacle_rotations(context: *mut fmc_context, on: i32) -> fmc_status;
    pub fn fmc_context_keep_pattern(context: *mut fmc_context, keep: i32) -> fmc_status;
}
