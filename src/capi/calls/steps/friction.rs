//! Steps with friction.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{optional, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::view::fmc_coords;

/// Begins a step with friction at `coords`, with the obstacles where they are: slip is counted from here. With friction
/// this comes before the first evaluation, and `fmc_context_commit_step` after every step that is accepted, which begins
/// the next. A step may be repeated any number of times: nothing has to be undone.
///
/// Accumulated elastic slip is kept; there is none at first. With friction, the contact at `coords` is measured. A facet
/// that touches later counts its slip from its first touch.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH`, `FMC_ERROR_STRIDE`, `FMC_ERROR_NON_FINITE_COORDINATE`, `FMC_ERROR_BUSY`;
/// with friction as `fmc_context_evaluate`. The context is then unchanged. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_begin_step(context: *mut fmc_context, coords: *const fmc_coords) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and a view.
        unsafe {
            write(
                context,
                |state| in_either!(&mut state.session, one => one.begin_step(reference("coords", coords)?, state.index_base)),
            )
        }
    })
}

/// Accepts the step that ends at `coords`: the elastic slip there is carried into the next step, which begins here.
/// Frozen friction is released. Call it with the coordinates that the host has accepted, and never within an iteration.
///
/// Errors: `FMC_ERROR_NO_STEP` before `fmc_context_begin_step`; else as `fmc_context_evaluate`. The context is then
/// unchanged. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_commit_step(context: *mut fmc_context, coords: *const fmc_coords) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and a view.
        unsafe {
            write(
                context,
                |state| in_either!(&mut state.session, one => one.commit_step(reference("coords", coords)?, state.index_base)),
            )
        }
    })
}

/// Freezes the facets on which friction acts, and their pressure, as they are at `coords`. This holds until the step is
/// committed, or until a call with `coords` NULL. Forces of friction are then minus the gradient of a convex potential, and
/// their tangent is symmetric and positive semidefinite. Repeat this at the new solution until nothing changes: it converges to
/// the solution with the current pressure. It also converges at large coefficients of friction, at which Newton's method with
/// the current pressure fails.
///
/// Errors: `FMC_ERROR_NO_STEP`; else as `fmc_context_evaluate`. Earlier frozen friction is then kept. Threads: one call
/// at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_freeze_friction(
    context: *mut fmc_context,
    coords: *const fmc_coords,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, and a view or NULL.
        unsafe {
            write(
                context,
                |state| in_either!(&mut state.session, one => one.freeze_friction(optional("coords", coords)?, state.index_base)),
            )
        }
    })
}
