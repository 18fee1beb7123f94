//! Steps of contact alone.

use super::mesh::{fmc_context, fmc_view};
use super::status::fmc_status;
use std::ffi::c_void;

/// As in the header.
pub type fmc_place = Option<unsafe extern "C" fn(*mut c_void, usize, *const f64, *mut f64) -> i32>;

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_contact_step_options {
    pub struct_size: usize,
    pub tolerance: f64,
    pub goal: f64,
    pub full_below: f64,
    pub most_iterations: i32,
    pub most_trials: i32,
    pub penetration: f64,
    pub reach: f64,
    pub most_updates: i32,
    pub soft_start: i32,
    pub reserved: [u64; 5],
}

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_contact_step_result {
    pub struct_size: usize,
    pub state: i32,
    pub iterations: i32,
    pub evaluation_count: usize,
    pub outside_count: usize,
    pub residual_at_start: f64,
    pub residual: f64,
    pub scale: f64,
    pub update_count: usize,
    pub penetration: f64,
    pub reserved: [u64; 6],
}

unsafe extern "C" {
    pub fn fmc_contact_step_options_init(options: *mut fmc_contact_step_options) -> fmc_status;
    pub fn fmc_context_contact_step(
        context: *mut fmc_context,
        coords: *const fmc_view,
        options: *const fmc_contact_step_options,
        freedoms: *const i64,
        count: usize,
        held: *const i64,
        held_count: usize,
        stiffness: *const f64,
        residual: *const f64,
        place: fmc_place,
        user: *mut c_void,
        displacement: *mut f64,
        result: *mut fmc_contact_step_result,
    ) -> fmc_status;
}
