//! Options of a context and of single pairs, and suggestions for their numbers.

use super::mesh::fmc_context;
use super::status::fmc_status;
use std::ffi::{c_char, c_void};

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_options {
    pub struct_size: usize,
    pub stiffness: f64,
    pub exponent: f64,
    pub spacing: f64,
    pub fiber_length: f64,
    pub fiber_count: u64,
    pub seed: u64,
    pub law: i32,
    pub estimator: i32,
    pub pattern: i32,
    pub weights: i32,
    pub momentum_correction: i32,
    pub self_contact: i32,
    pub check_cells: i32,
    pub threads: i32,
    pub index_base: i32,
    pub axisymmetric: i32,
    pub smoothing_length: f64,
    pub friction_coefficient: f64,
    pub friction_stiffness: f64,
    pub cohesion: f64,
    pub shear_limit: f64,
    pub memoryless_slip: f64,
    pub reserved: [u64; 10],
}

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_pair_options {
    pub struct_size: usize,
    pub stiffness: f64,
    pub exponent: f64,
    pub smoothing_length: f64,
    pub gap_offset: f64,
    pub friction_coefficient: f64,
    pub law: i32,
    pub excluded: i32,
    pub reserved: [u64; 10],
}

/// As in the header.
pub type fmc_log_callback = Option<unsafe extern "C" fn(*mut c_void, i32, *const c_char)>;

unsafe extern "C" {
    pub fn fmc_options_init(options: *mut fmc_options) -> fmc_status;
    pub fn fmc_options_set(options: *mut fmc_options, key: *const c_char, value: *const c_char) -> fmc_status;
    pub fn fmc_context_set_options(context: *mut fmc_context, options: *const fmc_options) -> fmc_status;
    pub fn fmc_pair_options_init(options: *mut fmc_pair_options) -> fmc_status;
    pub fn fmc_context_set_pair_options(
        context: *mut fmc_context,
        a_kind: i32,
        a: usize,
        b_kind: i32,
        b: usize,
        options: *const fmc_pair_options,
    ) -> fmc_status;
    pub fn fmc_context_pair_options(
        context: *const fmc_context,
        a_kind: i32,
        a: usize,
        b_kind: i32,
        b: usize,
        options: *mut fmc_pair_options,
    ) -> fmc_status;
    pub fn fmc_context_set_log(context: *mut fmc_context, callback: fmc_log_callback, user: *mut c_void) -> fmc_status;
    pub fn fmc_suggest_fiber_stiffness(pressure: f64, penetration: f64, stiffness: *mut f64) -> fmc_status;
    pub fn fmc_suggest_stiffness_from_modulus(
        dim: i32,
        exponent: f64,
        modulus: f64,
        facet_size: f64,
        stiffness: *mut f64,
    ) -> fmc_status;
    pub fn fmc_suggest_stiffness_from_pressure(
        dim: i32,
        exponent: f64,
        pressure: f64,
        overlap: f64,
        stiffness: *mut f64,
    ) -> fmc_status;
}
