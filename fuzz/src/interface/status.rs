//! Statuses, and texts about them.

use super::mesh::fmc_context;
use std::ffi::c_char;

/// `fmc_status`; its values are checked by range.
pub type fmc_status = i32;
/// `FMC_OK`.
pub const OK: fmc_status = 0;
/// `FMC_ERROR_BUSY`.
pub const BUSY: fmc_status = 28;
/// `FMC_ERROR_OBSTACLE_REMOVED`.
pub const REMOVED: fmc_status = 37;
/// `FMC_ERROR_PANIC`: a defect, always.
pub const PANIC: fmc_status = 30;
/// The last status that exists.
pub const LAST: fmc_status = 57;

unsafe extern "C" {
    pub fn fmc_version() -> *const c_char;
    pub fn fmc_abi_version() -> i32;
    pub fn fmc_has_feature(name: *const c_char) -> i32;
    pub fn fmc_status_name(status: i32) -> *const c_char;
    pub fn fmc_last_error() -> *const c_char;
    pub fn fmc_context_error(context: *const fmc_context) -> *const c_char;
}
