//! Forces, with a context and without one, and what they come from.

use super::mesh::{fmc_context, fmc_view};
use super::options::fmc_options;
use super::status::fmc_status;
use std::ffi::c_char;

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_result {
    pub struct_size: usize,
    pub volume: f64,
    pub volume_standard_error: f64,
    pub energy: f64,
    pub contact_area: f64,
    pub penetration: f64,
    pub fiber_count: usize,
    pub crossing_count: usize,
    pub facet_count: usize,
    pub pair_count: usize,
    pub body_count: usize,
    pub obstacle_count: usize,
    pub warning_count: usize,
    pub friction_energy: f64,
    pub friction_dissipation: f64,
    pub stick_area: f64,
    pub slip_area: f64,
    pub largest_slip: f64,
    pub reserved: [u64; 3],
}

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_resultant {
    pub id: i64,
    pub force: [f64; 3],
    pub moment: [f64; 3],
    pub node_count: usize,
    pub friction: [f64; 3],
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_pair {
    pub struct_size: usize,
    pub a_kind: i32,
    pub b_kind: i32,
    pub a: usize,
    pub b: usize,
    pub volume: f64,
    pub volume_standard_error: f64,
    pub energy: f64,
    pub pressure: f64,
    pub contact_area: f64,
    pub penetration: f64,
    pub spacing: f64,
    pub friction_energy: f64,
    pub friction_dissipation: f64,
    pub stick_area: f64,
    pub slip_area: f64,
    pub reserved: [u64; 4],
}

unsafe extern "C" {
    pub fn fmc_contact_force(
        dim: i32,
        coords: *const f64,
        node_count: usize,
        cell_type: i32,
        conn: *const i32,
        cell_count: usize,
        body_ids: *const i32,
        options: *const fmc_options,
        forces: *mut f64,
        volume: *mut f64,
    ) -> fmc_status;
    pub fn fmc_contact_force_i64(
        dim: i32,
        coords: *const f64,
        node_count: usize,
        cell_type: i32,
        conn: *const i64,
        cell_count: usize,
        body_ids: *const i64,
        options: *const fmc_options,
        forces: *mut f64,
        volume: *mut f64,
    ) -> fmc_status;
    pub fn fmc_context_evaluate(
        context: *mut fmc_context,
        coords: *const fmc_view,
        forces: *const fmc_view,
        flags: u32,
        result: *mut fmc_result,
    ) -> fmc_status;
    pub fn fmc_context_evaluate_tangent(
        context: *mut fmc_context,
        coords: *const fmc_view,
        flags: u32,
        forces: *const fmc_view,
        result: *mut fmc_result,
        entry_count: *mut usize,
        rank_one_count: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_stable_step(
        context: *mut fmc_context,
        coords: *const fmc_view,
        masses: *const f64,
        step: *mut f64,
    ) -> fmc_status;
    pub fn fmc_context_keep_patches(
        context: *mut fmc_context,
        coords: *const fmc_view,
        direction_count: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_body(context: *const fmc_context, index: usize, body: *mut fmc_resultant) -> fmc_status;
    pub fn fmc_context_obstacle(context: *const fmc_context, index: usize, obstacle: *mut fmc_resultant) -> fmc_status;
    pub fn fmc_context_pair(context: *const fmc_context, index: usize, pair: *mut fmc_pair) -> fmc_status;
    pub fn fmc_context_warning(
        context: *const fmc_context,
        index: usize,
        code: *mut i32,
        text: *mut *const c_char,
    ) -> fmc_status;
}
