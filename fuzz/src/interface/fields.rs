//! Contact at nodes and points, and weighted gaps.

use super::mesh::{fmc_context, fmc_view};
use super::status::fmc_status;

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_contact_side {
    pub kind: i32,
    pub node_count: i32,
    pub index: usize,
    pub cell: i64,
    pub nodes: [i64; 8],
    pub weights: [f64; 8],
    pub position: [f64; 3],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_contact_point {
    pub struct_size: usize,
    pub patch: usize,
    pub position: [f64; 3],
    pub normal: [f64; 3],
    pub gap: f64,
    pub pressure: f64,
    pub area: f64,
    pub friction: [f64; 3],
    pub slip: [f64; 3],
    pub sliding: f64,
    pub sides: [fmc_contact_side; 2],
    pub reserved: [u64; 8],
}

#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_gap_constraint {
    pub struct_size: usize,
    pub node: i64,
    pub body: usize,
    pub partner_kind: i32,
    pub reserved_flags: i32,
    pub partner: usize,
    pub gap: f64,
    pub area: f64,
    pub reserved: [u64; 4],
}

unsafe extern "C" {
    pub fn fmc_context_nodal_contact(
        context: *mut fmc_context,
        coords: *const fmc_view,
        pressure: *mut f64,
        gap: *mut f64,
        area: *mut f64,
        normal: *mut f64,
        friction: *mut f64,
        sliding: *mut f64,
        status: *mut i32,
        node_count: usize,
    ) -> fmc_status;
    pub fn fmc_context_find_contact_points(
        context: *mut fmc_context,
        coords: *const fmc_view,
        count: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_contact_points(
        context: *const fmc_context,
        points: *mut fmc_contact_point,
        capacity: usize,
    ) -> fmc_status;
    pub fn fmc_context_find_gap_constraints(
        context: *mut fmc_context,
        coords: *const fmc_view,
        reach: f64,
        count: *mut usize,
        entry_count: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_gap_constraints(
        context: *const fmc_context,
        rows: *mut fmc_gap_constraint,
        capacity: usize,
    ) -> fmc_status;
    pub fn fmc_context_gap_gradient(
        context: *const fmc_context,
        row_offsets: *mut i64,
        cols: *mut i64,
        values: *mut f64,
        capacity: usize,
    ) -> fmc_status;
}
