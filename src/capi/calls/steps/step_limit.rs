//! How far a host's step may go.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use crate::capi::structs::view::fmc_coords;

/// How far a step may go.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_step_limit {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Part of the step, at most 1, in which no body passes through another: a factor for a step of Newton's method.
    pub part: f64,
    /// Part of it at which the first gap closes, from the current slopes of the gaps: a linearisation holds up to there. Infinite
    /// if no gap closes within `part`.
    pub first_touch: f64,
    /// Zero.
    pub reserved: [u64; 4],
}

/// How far the nodes at `coords` may move along `step`, a motion of every node in the same layout, so that no body passes through
/// another. The overlap of surfaces grows by at most half a facet, and no body moves by more than half its thickness relative to
/// another. For hosts that iterate themselves.
///
/// Errors: as `fmc_context_gap_constraints`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_step_limit(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    step: *const fmc_coords,
    limit: *mut fmc_step_limit,
) -> fmc_status {
    entry(|| {
        let output = Output::required("limit", limit)?;
        // SAFETY: the host passes a context, two views, and a struct that may be written.
        unsafe {
            let found = write(context, |state| {
                let (coords, step) = (reference("coords", coords)?, reference("step", step)?);
                in_either!(&mut state.session, one => one.step_limit(coords, step, state.index_base))
            })?;
            let (struct_size, reserved) = (size_of::<fmc_step_limit>(), [0; 4]);
            output.write(fmc_step_limit { struct_size, part: found.part, first_touch: found.first_touch, reserved });
        }
        Ok(())
    })
}
