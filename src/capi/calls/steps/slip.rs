//! Elastic slip, for a restart.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::slice;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};

/// The elastic slip carried into the step: a row for every facet with slip and each body or obstacle that it faced. A restart needs it,
/// and the coordinates and poses at which the step began. Call `fmc_context_begin_step` there, then `fmc_context_set_slip`: the results
/// are bit-for-bit identical to the unbroken run.
///
/// A row is 8 numbers. The first is the facet, by its place in `fmc_context_boundary_facets` always from 0. Then follow the kind of
/// its partner, a value of `fmc_partner`, and the partner's index for `fmc_context_body_resultant` or
/// `fmc_context_obstacle_resultant`; then 1 where the facet's body is the second side of that pair, else 0. The last four are the
/// slip of the facet, three lengths, in 2D the last 0, and the slip since it rested, with `static_coefficient`, else 0. Rows ascend
/// by facet, partner and side.
///
/// `count` becomes their number; `slip` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`; no output is then
/// written. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_slip(
    context: *const fmc_context,
    slip: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, and room for `capacity` numbers.
        unsafe {
            let state = read(context)?;
            room.write("numbers of the slip", "slip", &in_either!(&state.session, one => one.slip())?, slip)
        }
    })
}

/// Sets the elastic slip carried into the current step: `count` numbers, in rows as `fmc_context_slip` writes them. Facets
/// without a row have none.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_LENGTH` where the last row is not whole.
/// `FMC_ERROR_INDEX_OUT_OF_RANGE` for a row that names a facet or a partner that does not exist, that occurs twice, or that is not valid.
/// `FMC_ERROR_BAD_VALUE`, `FMC_ERROR_NON_FINITE_SLIP`, `FMC_ERROR_BUSY`; the old slip is then kept. Threads: one call at a time on a
/// context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_slip(context: *mut fmc_context, slip: *const f64, count: usize) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` numbers.
        unsafe {
            write(context, |state| {
                let slip = slice("slip", slip, count, 1)?;
                in_either!(&mut state.session, one => one.set_slip(slip))
            })
        }
    })
}
