//! The obstacles of a context: asked for, moved, removed.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::pose::fmc_pose;

/// Kind of an obstacle's shape, a value of `fmc_shape_kind`, and its current pose. Either output may be NULL.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_REMOVED`, `FMC_ERROR_BUSY`.
/// Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_obstacle_shape(
    context: *const fmc_context,
    obstacle: usize,
    kind: *mut i32,
    pose: *mut fmc_pose,
) -> fmc_status {
    entry(|| {
        let (kind, pose) = (Output::optional("kind", kind)?, Output::optional("pose", pose)?);
        // SAFETY: the host passes a context.
        let found = in_either!(&unsafe { read(context) }?.session, one => one.obstacle(obstacle))?;
        // SAFETY: the outputs, where given, may be written.
        unsafe {
            kind.write(found.0 as i32);
            pose.write(found.1);
        }
        Ok(())
    })
}

/// Moves an obstacle, and turns and scales it: the whole pose is set, so that a pose with only a position turns a ceiling
/// into a floor. To move it only, fill the pose by `fmc_context_obstacle_shape` and change its position. Results of the
/// last evaluation are kept.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_REMOVED`,
/// `FMC_ERROR_BAD_POSE`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_pose(
    context: *mut fmc_context,
    obstacle: usize,
    pose: *const fmc_pose,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and a pose.
        unsafe {
            write(
                context,
                |state| in_either!(&mut state.session, one => one.set_pose(obstacle, *reference("pose", pose)?)),
            )
        }
    })
}

/// Removes an obstacle, and the options of its pairs. All other obstacles keep their indices, and the index of the
/// removed one is never reused. It stays in the counts, with a resultant of zero, and its row in the tangent is empty.
/// Results of the last evaluation are kept. Afterwards the library does not use the callback and the `user` of a signed
/// distance any more.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_OBSTACLE_OUT_OF_RANGE`, `FMC_ERROR_OBSTACLE_REMOVED` if it was removed
/// before, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_remove_obstacle(context: *mut fmc_context, obstacle: usize) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        unsafe { write(context, |state| in_either!(&mut state.session, one => one.remove_obstacle(obstacle))) }
    })
}
