//! Contexts from meshes, and their surface.

use super::options::fmc_options;
use super::status::fmc_status;

/// Opaque.
#[repr(C)]
pub struct fmc_context {
    _private: [u8; 0],
}

/// As in the header, for coordinates and forces alike.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_view {
    pub data: *mut f64,
    pub node_count: usize,
    pub node_stride: isize,
    pub axis_stride: isize,
}

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_cell_block {
    pub cell_type: i32,
    pub conn: *const i32,
    pub cell_count: usize,
}

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_cell_block_i64 {
    pub cell_type: i32,
    pub conn: *const i64,
    pub cell_count: usize,
}

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_facet_block {
    pub facet_type: i32,
    pub conn: *const i32,
    pub facet_count: usize,
}

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_facet_block_i64 {
    pub facet_type: i32,
    pub conn: *const i64,
    pub facet_count: usize,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_boundary_facet {
    pub struct_size: usize,
    pub body: usize,
    pub cell: i64,
    pub given: i64,
    pub local_face: i32,
    pub node_count: i32,
    pub nodes: [i64; 4],
    pub reserved: [u64; 4],
}

unsafe extern "C" {
    pub fn fmc_context_new_from_cells(
        dim: i32,
        coords: *const fmc_view,
        blocks: *const fmc_cell_block,
        block_count: usize,
        body_ids: *const i32,
        options: *const fmc_options,
        context: *mut *mut fmc_context,
    ) -> fmc_status;
    pub fn fmc_context_new_from_cells_i64(
        dim: i32,
        coords: *const fmc_view,
        blocks: *const fmc_cell_block_i64,
        block_count: usize,
        body_ids: *const i64,
        options: *const fmc_options,
        context: *mut *mut fmc_context,
    ) -> fmc_status;
    pub fn fmc_context_new_from_facets(
        dim: i32,
        coords: *const fmc_view,
        facets: *const i32,
        facet_count: usize,
        body_ids: *const i32,
        options: *const fmc_options,
        context: *mut *mut fmc_context,
    ) -> fmc_status;
    pub fn fmc_context_new_from_facets_i64(
        dim: i32,
        coords: *const fmc_view,
        facets: *const i64,
        facet_count: usize,
        body_ids: *const i64,
        options: *const fmc_options,
        context: *mut *mut fmc_context,
    ) -> fmc_status;
    pub fn fmc_context_new_from_facet_blocks(
        dim: i32,
        coords: *const fmc_view,
        blocks: *const fmc_facet_block,
        block_count: usize,
        body_ids: *const i32,
        options: *const fmc_options,
        context: *mut *mut fmc_context,
    ) -> fmc_status;
    pub fn fmc_context_new_from_facet_blocks_i64(
        dim: i32,
        coords: *const fmc_view,
        blocks: *const fmc_facet_block_i64,
        block_count: usize,
        body_ids: *const i64,
        options: *const fmc_options,
        context: *mut *mut fmc_context,
    ) -> fmc_status;
    pub fn fmc_context_free(context: *mut *mut fmc_context) -> fmc_status;
    pub fn fmc_context_counts(
        context: *const fmc_context,
        node_count: *mut usize,
        facet_count: *mut usize,
        body_count: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_boundary_facets(
        context: *const fmc_context,
        facets: *mut fmc_boundary_facet,
        capacity: usize,
    ) -> fmc_status;
    pub fn fmc_context_set_reference(context: *mut fmc_context, coords: *const fmc_view) -> fmc_status;
    pub fn fmc_context_set_symmetry_nodes(context: *mut fmc_context, nodes: *const i64, count: usize) -> fmc_status;
    pub fn fmc_context_set_basis(
        context: *mut fmc_context,
        unknown_count: usize,
        row_offsets: *const i64,
        unknowns: *const i64,
        weights: *const f64,
        entry_count: usize,
    ) -> fmc_status;
    pub fn fmc_context_point_weights_size(
        context: *const fmc_context,
        point_count: *mut usize,
        entry_count: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_point_weights(
        context: *const fmc_context,
        row_offsets: *mut i64,
        point_capacity: usize,
        nodes: *mut i64,
        weights: *mut f64,
        capacity: usize,
    ) -> fmc_status;
}
