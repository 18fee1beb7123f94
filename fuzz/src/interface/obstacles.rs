//! Obstacles.

use super::mesh::{fmc_context, fmc_view};
use super::status::fmc_status;
use std::ffi::c_void;

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_pose {
    pub position: [f64; 3],
    pub rotation: [f64; 9],
    pub scale: f64,
}

/// As in the header.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_part {
    pub shape: i32,
    pub facet_count: usize,
    pub radius: f64,
    pub half_height: f64,
    pub half_extents: [f64; 3],
    pub points: *const fmc_view,
    pub facets: *const i32,
    pub pose: fmc_pose,
}

/// As in the header.
pub type fmc_signed_distance = Option<unsafe extern "C" fn(*mut c_void, usize, *const f64, *mut f64, *mut f64) -> i32>;

unsafe extern "C" {
    pub fn fmc_pose_init(pose: *mut fmc_pose) -> fmc_status;
    pub fn fmc_pose_along(dim: i32, position: *const f64, axis: *const f64, pose: *mut fmc_pose) -> fmc_status;
    pub fn fmc_context_add_half_space(
        context: *mut fmc_context,
        pose: *const fmc_pose,
        obstacle: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_add_ball(
        context: *mut fmc_context,
        radius: f64,
        pose: *const fmc_pose,
        obstacle: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_add_cuboid(
        context: *mut fmc_context,
        half_extents: *const f64,
        pose: *const fmc_pose,
        obstacle: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_add_cylinder(
        context: *mut fmc_context,
        radius: f64,
        half_height: f64,
        pose: *const fmc_pose,
        obstacle: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_add_cone(
        context: *mut fmc_context,
        radius: f64,
        half_height: f64,
        pose: *const fmc_pose,
        obstacle: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_add_capsule(
        context: *mut fmc_context,
        radius: f64,
        half_height: f64,
        pose: *const fmc_pose,
        obstacle: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_add_polytope(
        context: *mut fmc_context,
        points: *const fmc_view,
        facets: *const i32,
        facet_count: usize,
        pose: *const fmc_pose,
        obstacle: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_add_polytope_i64(
        context: *mut fmc_context,
        points: *const fmc_view,
        facets: *const i64,
        facet_count: usize,
        pose: *const fmc_pose,
        obstacle: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_add_convex_hull(
        context: *mut fmc_context,
        points: *const fmc_view,
        pose: *const fmc_pose,
        obstacle: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_add_height_field(
        context: *mut fmc_context,
        counts: *const usize,
        lengths: *const f64,
        heights: *const f64,
        thickness: f64,
        pose: *const fmc_pose,
        obstacle: *mut usize,
    ) -> fmc_status;
    pub fn fmc_part_init(part: *mut fmc_part) -> fmc_status;
    pub fn fmc_context_add_compound(
        context: *mut fmc_context,
        parts: *const fmc_part,
        part_count: usize,
        pose: *const fmc_pose,
        obstacle: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_add_signed_distance(
        context: *mut fmc_context,
        callback: fmc_signed_distance,
        user: *mut c_void,
        pose: *const fmc_pose,
        obstacle: *mut usize,
    ) -> fmc_status;
    pub fn fmc_context_obstacle_shape(
        context: *const fmc_context,
        obstacle: usize,
        shape: *mut i32,
        pose: *mut fmc_pose,
    ) -> fmc_status;
    pub fn fmc_context_remove_obstacle(context: *mut fmc_context, obstacle: usize) -> fmc_status;
    pub fn fmc_context_set_pose(context: *mut fmc_context, obstacle: usize, pose: *const fmc_pose) -> fmc_status;
}
