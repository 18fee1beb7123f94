//! Parts of a compound.

use super::boundary::entry;
use super::failure::Failure;
use super::pointer::{Output, reference};
use super::pose::fmc_pose;
use super::shape::{Facets, ShapeOf};
use super::status::fmc_status;
use super::status::fmc_status::FMC_ERROR_UNKNOWN_OPTION;
use super::view::fmc_coords;

/// Shape of a part of a compound.
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
}

use fmc_shape::*;

/// A part of a compound. Set it by `fmc_part_init`, then the entries that its shape reads.
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

impl fmc_part {
    /// The shape that the part names.
    ///
    /// # Safety
    /// The host guarantees the view of the points.
    pub(super) unsafe fn shape(&self) -> Result<ShapeOf, Failure> {
        let &fmc_part { radius, half_height, facet_count, .. } = self;
        // SAFETY: passed on to the caller.
        let points = || unsafe { reference("points", self.points) }.copied();
        let is = |shape: fmc_shape| self.shape == shape as i32;
        Ok(if is(FMC_SHAPE_HALF_SPACE) {
            ShapeOf::HalfSpace
        } else if is(FMC_SHAPE_BALL) {
            ShapeOf::Ball { radius }
        } else if is(FMC_SHAPE_CUBOID) {
            ShapeOf::Cuboid { half_extents: self.half_extents.as_ptr() }
        } else if is(FMC_SHAPE_CYLINDER) {
            ShapeOf::Cylinder { radius, half_height }
        } else if is(FMC_SHAPE_CONE) {
            ShapeOf::Cone { radius, half_height }
        } else if is(FMC_SHAPE_CAPSULE) {
            ShapeOf::Capsule { radius, half_height }
        } else if is(FMC_SHAPE_POLYTOPE) {
            ShapeOf::Polytope { points: points()?, facets: Facets::Narrow(self.facets), facet_count }
        } else if is(FMC_SHAPE_CONVEX_HULL) {
            ShapeOf::ConvexHull { points: points()? }
        } else {
            return Err(Failure::new(FMC_ERROR_UNKNOWN_OPTION, format!("{} is no value of fmc_shape", self.shape)));
        })
    }
}

/// Sets a part to a half-space at the origin of the compound, with nothing else given.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_part_init(part: *mut fmc_part) -> fmc_status {
    entry(|| {
        let output = Output::required("part", part)?;
        let empty = fmc_part {
            shape: FMC_SHAPE_HALF_SPACE as i32,
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
