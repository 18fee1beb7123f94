//! Rigid partners.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{Output, optional, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::pose::fmc_pose;
use crate::capi::structs::shape::fmc_shape;

/// Adds a rigid obstacle of any shape; everything but a signed distance is copied.
///
/// Obstacles are in contact with the bodies of the mesh, not with one another. `pose` may be NULL for the origin;
/// `fmc_pose_along` makes the pose of a half-space from a point and its outward normal. `obstacle`, which may be NULL
/// too, receives the index: 0 for the first obstacle of the context, then 1, 2, ..., also after others were removed.
///
/// Both estimators support shapes that have facets or become polytopes; half-spaces and boxes too. `fibers`, `auto`, and the
/// law "depth" support all of them.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_BAD_VALUE` for a `kind` or an
/// `index_size` that does not exist, `FMC_ERROR_BAD_POSE`, `FMC_ERROR_NOT_POSITIVE`, `FMC_ERROR_BUSY`. For a polytope as
/// `fmc_context_new_from_facets`; for a convex hull `FMC_ERROR_DEGENERATE_HULL`, `FMC_ERROR_NON_FINITE_COORDINATE`; for a height
/// field `FMC_ERROR_TOO_FEW_HEIGHTS`, `FMC_ERROR_NON_FINITE_HEIGHT`; for a compound `FMC_ERROR_EMPTY_COMPOUND` and the errors of
/// its parts. `FMC_ERROR_UNSUPPORTED` for hulls and compounds if the library lacks the feature "shapes". Threads: one call at a
/// time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_add_obstacle(
    context: *mut fmc_context,
    shape: *const fmc_shape,
    pose: *const fmc_pose,
    obstacle: *mut usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, a shape with its arrays, a pose or NULL, and an output or NULL.
        unsafe {
            write(context, |state| {
                let output = Output::optional("obstacle", obstacle)?;
                let (shape, pose) = (reference("shape", shape)?, optional("pose", pose)?.copied().unwrap_or_default());
                let index = in_either!(&mut state.session, one => one.add_obstacle(shape, pose, state.index_base))?;
                output.write(index);
                Ok(())
            })
        }
    })
}
