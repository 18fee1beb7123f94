//! Parts of a compound.

use super::pose::fmc_pose;
use super::view::fmc_coords;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::Output;
use crate::capi::boundary::status::fmc_status;

/// Shape of an obstacle, and of a part of a compound.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum fmc_shape {
    /// As `fmc_context_add_half_space`.
    FMC_SHAPE_HALF_SPACE = 0,
    /// As `fmc_context_add_ball`: `radius`.
    FMC_SHAPE_BALL = 1,
    /// As `fmc_context_add_cuboid`: `half_extents`.
    FMC_SHAPE_CUBOID = 2,
    /// As `fmc_context_add_cylinder`: `radius`, `half_height`.
    FMC_SHAPE_CYLINDER = 3,
    /// As `fmc_context_add_cone`: `radius`, `half_height`.
    FMC_SHAPE_CONE = 4,
    /// As `fmc_context_add_capsule`: `radius`, `half_height`.
    FMC_SHAPE_CAPSULE = 5,
    /// As `fmc_context_add_polytope`: `points`, `facets`, `facet_count`.
    FMC_SHAPE_POLYTOPE = 6,
    /// As `fmc_context_add_convex_hull`: `points`.
    FMC_SHAPE_CONVEX_HULL = 7,
    /// As `fmc_context_add_height_field`; of obstacles, not of parts, as the next two.
    FMC_SHAPE_HEIGHT_FIELD = 8,
    /// As `fmc_context_add_compound`.
    FMC_SHAPE_COMPOUND = 9,
    /// As `fmc_context_add_signed_distance`.
    FMC_SHAPE_SIGNED_DISTANCE = 10,
}

/// A part of a compound. Initialise it by `fmc_part_init`, then set the fields that its shape uses.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_part {
    /// A value of `fmc_shape`.
    pub shape: i32,
    /// Number of facets.
    pub facet_count: usize,
    /// Radius.
    pub radius: f64,
    /// Half of the height.
    pub half_height: f64,
    /// Halves of the sides, of which the first `dim` are read.
    pub half_extents: [f64; 3],
    /// Corners.
    pub points: *const fmc_coords,
    /// Numbers of corners, (facet_count, dim).
    pub facets: *const i32,
    /// Pose of the part in the frame of the compound.
    pub pose: fmc_pose,
}

/// Sets a part to a half-space at the origin of the compound, with sizes 0 and pointers NULL.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_part_init(part: *mut fmc_part) -> fmc_status {
    entry(|| {
        let output = Output::required("part", part)?;
        let empty = fmc_part {
            shape: fmc_shape::FMC_SHAPE_HALF_SPACE as i32,
            facet_count: 0,
            radius: 0.0,
            half_height: 0.0,
            half_extents: [0.0; 3],
            points: std::ptr::null(),
            facets: std::ptr::null(),
            pose: fmc_pose::default(),
        };
        // SAFETY: the host passes a part that may be written.
        unsafe { output.write(empty) };
        Ok(())
    })
}
