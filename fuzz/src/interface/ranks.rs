//! Ranks that share the work, and a mesh in parts.

use super::mesh::{fmc_cell_block, fmc_context, fmc_view};
use super::options::fmc_options;
use super::status::fmc_status;
use std::ffi::c_void;

/// As in the header.
pub type fmc_all_gather = Option<
    unsafe extern "C" fn(user: *mut c_void, send: *const c_void, counts: *const u64, received: *mut c_void) -> i32,
>;

/// As in the header.
pub type fmc_all_to_all = Option<
    unsafe extern "C" fn(
        user: *mut c_void,
        send: *const c_void,
        send_counts: *const u64,
        received: *mut c_void,
        received_counts: *const u64,
    ) -> i32,
>;

#[repr(C)]
pub struct fmc_communicator {
    pub struct_size: usize,
    pub rank: i32,
    pub size: i32,
    pub all_gather: fmc_all_gather,
    pub user: *mut c_void,
    pub all_to_all: fmc_all_to_all,
    pub reserved: [u64; 5],
}

#[repr(C)]
#[derive(Default)]
pub struct fmc_rank_counts {
    pub item_count: u64,
    pub own_item_count: u64,
    pub call_count: u64,
    pub sent_bytes: u64,
    pub received_bytes: u64,
}

#[repr(C)]
pub struct fmc_mesh_part {
    pub struct_size: usize,
    pub coords: fmc_view,
    pub node_numbers: *const i64,
    pub blocks: *const fmc_cell_block,
    pub block_count: usize,
    pub cell_numbers: *const i64,
    pub body_ids: *const i32,
    pub reach: f64,
}

#[repr(C)]
#[derive(Default)]
pub struct fmc_gathered_counts {
    pub node_count: u64,
    pub cell_count: u64,
    pub facet_count: u64,
    pub whole_facet_count: u64,
    pub own_cell_count: u64,
    pub gather_count: u64,
}

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_carried_slip {
    pub cell: i64,
    pub face: i32,
    pub part: i32,
    pub slip: [f64; 3],
}

unsafe extern "C" {
    pub fn fmc_context_carried_slip(
        context: *const fmc_context,
        carried: *mut fmc_carried_slip,
        capacity: usize,
        count: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_set_carried_slip(
        context: *mut fmc_context,
        carried: *const fmc_carried_slip,
        count: usize,
    ) -> fmc_status;
    pub fn fmc_communicator_init(communicator: *mut fmc_communicator) -> fmc_status;
    pub fn fmc_context_set_communicator(context: *mut fmc_context, communicator: *const fmc_communicator)
    -> fmc_status;
    pub fn fmc_context_rank_counts(context: *const fmc_context, counts: *mut fmc_rank_counts) -> fmc_status;
    pub fn fmc_context_new_from_part(
        dim: i32,
        communicator: *const fmc_communicator,
        part: *const fmc_mesh_part,
        options: *const fmc_options,
        context: *mut *mut fmc_context,
    ) -> fmc_status;
    pub fn fmc_context_bring(context: *mut fmc_context, coords: *const fmc_view, renumbered: *mut i32) -> fmc_status;
    pub fn fmc_context_gathered_counts(context: *const fmc_context, counts: *mut fmc_gathered_counts) -> fmc_status;
    pub fn fmc_context_gathered_nodes(
        context: *const fmc_context,
        numbers: *mut i64,
        own_nodes: *mut i32,
        coords: *mut f64,
        capacity: usize,
    ) -> fmc_status;
    pub fn fmc_context_gathered_cells(context: *const fmc_context, numbers: *mut i64, capacity: usize) -> fmc_status;
}
