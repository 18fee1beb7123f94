//! Steps of friction.

use super::mesh::{fmc_context, fmc_view};
use super::options::fmc_options;
use super::status::fmc_status;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_friction_step {
    pub struct_size: usize,
    pub start: *const f64,
    pub reference: *const f64,
    pub slip: *const f64,
    pub next_slip: *mut f64,
    pub slip_length: usize,
    pub facet_count: usize,
    pub reserved: [u64; 8],
}

unsafe extern "C" {
    pub fn fmc_friction_step_init(step: *mut fmc_friction_step) -> fmc_status;
    pub fn fmc_contact_force_step(
        dim: i32,
        coords: *const f64,
        node_count: usize,
        cell_type: i32,
        conn: *const i32,
        cell_count: usize,
        body_ids: *const i32,
        options: *const fmc_options,
        step: *mut fmc_friction_step,
        forces: *mut f64,
        volume: *mut f64,
    ) -> fmc_status;
    pub fn fmc_contact_force_step_i64(
        dim: i32,
        coords: *const f64,
        node_count: usize,
        cell_type: i32,
        conn: *const i64,
        cell_count: usize,
        body_ids: *const i64,
        options: *const fmc_options,
        step: *mut fmc_friction_step,
        forces: *mut f64,
        volume: *mut f64,
    ) -> fmc_status;
    pub fn fmc_context_begin_step(context: *mut fmc_context, coords: *const fmc_view) -> fmc_status;
    pub fn fmc_context_commit_step(context: *mut fmc_context, coords: *const fmc_view) -> fmc_status;
    pub fn fmc_context_freeze_friction(context: *mut fmc_context, coords: *const fmc_view) -> fmc_status;
    pub fn fmc_context_slip(context: *const fmc_context, slip: *mut f64, capacity: usize) -> fmc_status;
    pub fn fmc_context_set_slip(context: *mut fmc_context, slip: *const f64, length: usize) -> fmc_status;
}
