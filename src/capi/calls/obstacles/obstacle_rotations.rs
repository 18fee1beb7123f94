//! Rotations of obstacles in the tangent.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_BAD_VALUE;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};

/// Gives tangents rows and columns for the rotations of the obstacles, with `on` 1, from the next one on; 0, the default:
/// none. With n nodes and m obstacles, removed ones included, the rotation of obstacle o is node n + m + o. It is a
/// rotation vector about the position of its pose, which moves along. In 2D its first entry is the angle, and the second
/// has only zeros. Rotations follow wherever there are translations of obstacles, as with `FMC_CSR_OBSTACLES`.
///
/// It is the second derivative of the energy, and symmetric. The moment M about the position (moment of
/// `fmc_context_obstacle_resultant` minus position x force) changes by -K dtheta + 1/2 dtheta x M as the obstacle turns by dtheta.
/// With axisymmetry obstacles do not rotate, and there are only zeros. Friction adds the terms of its tangent, unsymmetric without
/// `FMC_TANGENT_SYMMETRIC`. Where a body meets an obstacle by the law "fiber", whose lines do not rotate with it, the tangent returns
/// `FMC_ERROR_UNSUPPORTED`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BAD_VALUE` for another number, `FMC_ERROR_BUSY`. Threads: one call
/// at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_obstacle_rotations(context: *mut fmc_context, on: i32) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        unsafe {
            write(context, |state| {
                if on != 0 && on != 1 {
                    return Err(Failure::new(FMC_ERROR_BAD_VALUE, format!("'on' is {on}, not 0 or 1")));
                }
                in_either!(&mut state.session, one => one.set_obstacle_rotations(on == 1));
                Ok(())
            })
        }
    })
}
