//! Surfaces moved out by what they penetrate.

use super::mesh::{fmc_context, fmc_view};
use super::status::fmc_status;

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_augmentation {
    pub struct_size: usize,
    pub penetration: f64,
    pub change: f64,
    pub multiplier_count: usize,
    pub is_enough: i32,
    pub reserved_flags: i32,
    pub reserved: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_multiplier {
    pub struct_size: usize,
    pub node: i64,
    pub body: usize,
    pub partner_kind: i32,
    pub reserved_flags: i32,
    pub partner: usize,
    pub shift: f64,
    pub towards: [f64; 3],
    pub reserved: [u64; 4],
}

unsafe extern "C" {
    pub fn fmc_context_augment(
        context: *mut fmc_context,
        coords: *const fmc_view,
        reach: f64,
        enough: f64,
        found: *mut fmc_augmentation,
    ) -> fmc_status;
    pub fn fmc_context_stiffen(context: *mut fmc_context, factor: f64) -> fmc_status;
    pub fn fmc_context_multipliers(
        context: *const fmc_context,
        rows: *mut fmc_multiplier,
        capacity: usize,
        count: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_set_multipliers(
        context: *mut fmc_context,
        rows: *const fmc_multiplier,
        count: usize,
    ) -> fmc_status;
}
