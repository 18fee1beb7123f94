//! Rigid partners.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, optional, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_NULL_POINTER;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::part::fmc_part;
use crate::capi::structs::pose::fmc_pose;
use crate::capi::structs::shape::{Facets, ShapeOf};
use crate::capi::structs::signed_distance::{Callback, fmc_signed_distance};
use crate::capi::structs::view::fmc_coords;
use std::ffi::c_void;

/// Adds an obstacle and writes its index.
///
/// # Safety
/// The host guarantees the context, the pose if it is not NULL, the shape's arrays, and the output if it is not NULL.
unsafe fn add(
    context: *mut fmc_context,
    pose: *const fmc_pose,
    obstacle: *mut usize,
    shape: impl FnOnce() -> Result<ShapeOf, Failure>,
) -> fmc_status {
    entry(|| {
        // SAFETY: passed on to the caller.
        unsafe {
            write(context, |state| {
                let output = Output::optional("obstacle", obstacle)?;
                let pose = optional("pose", pose)?.copied().unwrap_or_default();
                let index = state.session.add_obstacle(shape()?, pose, state.index_base)?;
                output.write(index);
                Ok(())
            })
        }
    })
}

/// Adds a half-space: all points of its frame whose last coordinate is at most 0. `fmc_pose_along` places it by a
/// point and its outward normal.
///
/// Obstacles are in contact with the bodies of the mesh, not with one another. `pose` may be NULL for the origin;
/// `obstacle`, which may be NULL too, receives the index: 0 for the first obstacle of the context, then 1, 2, ...,
/// also after others were removed.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_POSE`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_half_space(
    context: *mut fmc_context,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    // SAFETY: the host passes a context, a pose or NULL, and an output or NULL.
    unsafe { add(context, pose, obstacle, || Ok(ShapeOf::HalfSpace)) }
}

/// Adds a ball (2D: a disc) about the origin of its frame. Otherwise as `fmc_context_add_half_space`; also
/// `FMC_ERROR_NOT_POSITIVE`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_ball(
    context: *mut fmc_context,
    radius: f64,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    // SAFETY: the host passes a context, a pose or NULL, and an output or NULL.
    unsafe { add(context, pose, obstacle, || Ok(ShapeOf::Ball { radius })) }
}

/// Adds a box about the origin of its frame; `half_extents` are `dim` halves of its sides. Otherwise as
/// `fmc_context_add_ball`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_cuboid(
    context: *mut fmc_context,
    half_extents: *const f64,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    // SAFETY: the host passes a context, `dim` numbers, a pose or NULL, and an output or NULL.
    unsafe { add(context, pose, obstacle, || Ok(ShapeOf::Cuboid { half_extents })) }
}

/// Adds a cylinder (2D: a rectangle) about the last axis of its frame, centred. Otherwise as `fmc_context_add_ball`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_cylinder(
    context: *mut fmc_context,
    radius: f64,
    half_height: f64,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    // SAFETY: the host passes a context, a pose or NULL, and an output or NULL.
    unsafe { add(context, pose, obstacle, || Ok(ShapeOf::Cylinder { radius, half_height })) }
}

/// Adds a cone (2D: a triangle) about the last axis of its frame: apex at +half_height, base of the given radius at
/// -half_height. Otherwise as `fmc_context_add_ball`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_cone(
    context: *mut fmc_context,
    radius: f64,
    half_height: f64,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    // SAFETY: the host passes a context, a pose or NULL, and an output or NULL.
    unsafe { add(context, pose, obstacle, || Ok(ShapeOf::Cone { radius, half_height })) }
}

/// Adds a capsule (2D: a stadium): all points within `radius` of the segment from -half_height to +half_height on the
/// last axis of its frame. Otherwise as `fmc_context_add_ball`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_capsule(
    context: *mut fmc_context,
    radius: f64,
    half_height: f64,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    // SAFETY: the host passes a context, a pose or NULL, and an output or NULL.
    unsafe { add(context, pose, obstacle, || Ok(ShapeOf::Capsule { radius, half_height })) }
}

/// Adds a closed polygon (2D) or triangle mesh (3D), which is copied.
///
/// `points` are its corners, in its frame; `facets`, (facet_count, dim), are numbers of corners counted from the option
/// `index_base`: in 2D the body lies left of an edge, in 3D a triangle runs counter-clockwise seen from outside.
///
/// Errors: those of `fmc_context_add_half_space` and of `fmc_context_new_from_facets`. Threads: one call at a time on a
/// context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_polytope(
    context: *mut fmc_context,
    points: *const fmc_coords,
    facets: *const i32,
    facet_count: usize,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    // SAFETY: the host passes a context, both arrays, a pose or NULL, and an output or NULL.
    unsafe {
        add(context, pose, obstacle, || {
            let points = *reference("points", points)?;
            Ok(ShapeOf::Polytope { points, facets: Facets::Narrow(facets), facet_count })
        })
    }
}

/// `fmc_context_add_polytope` with 64-bit numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_polytope_i64(
    context: *mut fmc_context,
    points: *const fmc_coords,
    facets: *const i64,
    facet_count: usize,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    // SAFETY: the host passes a context, both arrays, a pose or NULL, and an output or NULL.
    unsafe {
        add(context, pose, obstacle, || {
            let points = *reference("points", points)?;
            Ok(ShapeOf::Polytope { points, facets: Facets::Wide(facets), facet_count })
        })
    }
}

/// Adds the convex hull of points, which are copied; points inside it have no effect. The obstacle is a polytope.
///
/// Errors: those of `fmc_context_add_half_space`; `FMC_ERROR_DEGENERATE_HULL`, `FMC_ERROR_NON_FINITE_COORDINATE`,
/// `FMC_ERROR_UNSUPPORTED` if the library lacks the feature "shapes". Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_convex_hull(
    context: *mut fmc_context,
    points: *const fmc_coords,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    // SAFETY: the host passes a context, the points, a pose or NULL, and an output or NULL.
    unsafe { add(context, pose, obstacle, || Ok(ShapeOf::ConvexHull { points: *reference("points", points)? })) }
}

/// Adds the solid below a height field, which is copied. The obstacle is a polytope.
///
/// The grid is centred on the origin of its frame, perpendicular to the last axis, along which heights are measured:
/// `counts` are the `dim` - 1 numbers of points along its axes, `lengths` its lengths along them, and `heights` the
/// heights, with the index along the grid's last axis running fastest. In 3D every cell is split along the diagonal
/// from its corner of least x and y. The solid has a flat bottom, `thickness` below the lowest height, and vertical
/// walls.
///
/// Errors: those of `fmc_context_add_half_space`; `FMC_ERROR_TOO_FEW_HEIGHTS`, `FMC_ERROR_NON_FINITE_HEIGHT`,
/// `FMC_ERROR_NOT_POSITIVE`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_height_field(
    context: *mut fmc_context,
    counts: *const usize,
    lengths: *const f64,
    heights: *const f64,
    thickness: f64,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    // SAFETY: the host passes a context, the arrays, a pose or NULL, and an output or NULL.
    unsafe { add(context, pose, obstacle, || Ok(ShapeOf::HeightField { counts, lengths, heights, thickness })) }
}

/// Adds a union of shapes, which may overlap; everything is copied. Only the estimator `fibers` supports it.
///
/// Its signed distance is the least of those of its parts: exact outside, and inside a single part; where parts
/// overlap, the depth of a point is its largest depth in any part.
///
/// Errors: those of the shapes of its parts; `FMC_ERROR_EMPTY_COMPOUND`; `FMC_ERROR_BAD_VALUE` for a number that
/// is not a value of `fmc_shape`; `FMC_ERROR_UNSUPPORTED` if the library lacks the feature "shapes". Threads: one call
/// at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_compound(
    context: *mut fmc_context,
    parts: *const fmc_part,
    part_count: usize,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    // SAFETY: the host passes a context, the parts, a pose or NULL, and an output or NULL.
    unsafe { add(context, pose, obstacle, || Ok(ShapeOf::Compound { parts, part_count })) }
}

/// Adds a body given by its signed distance; `user` is passed to the callback, and both must outlive the context, or
/// the obstacle if it is removed before. They are used on the thread that evaluates the context. Only the estimator
/// `fibers` supports it.
///
/// Errors: those of `fmc_context_add_half_space`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_signed_distance(
    context: *mut fmc_context,
    callback: fmc_signed_distance,
    user: *mut c_void,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    // SAFETY: the host passes a context, a callback that keeps to its contract, a pose or NULL, and an output or NULL.
    unsafe {
        add(context, pose, obstacle, || {
            let function = callback.ok_or_else(|| Failure::new(FMC_ERROR_NULL_POINTER, "'callback' is NULL"))?;
            Ok(ShapeOf::SignedDistance(Callback { function, user }))
        })
    }
}
