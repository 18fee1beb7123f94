//! Elastic slip, for a restart.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::slice;
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_LENGTH;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};

/// The elastic slip that was carried into the step, `dim` numbers for every facet in dense rows, in the order
/// of `fmc_context_boundary_facets`: that of the facet against what it faces. With the
/// coordinates and the poses at which the step began it is all that a restart needs: `fmc_context_begin_step` there, then
/// `fmc_context_set_slip`, gives the bits of the unbroken run.
///
/// `count` becomes how many numbers there are; `slip` has room for `capacity`. NULL with capacity 0: that alone is asked for.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`; nothing is written then.
/// Threads: several at once on one context, as long as no call changes it.
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
            room.write("numbers of the slip", "slip", in_either!(&state.session, one => one.slip())?, slip)
        }
    })
}

/// Sets the elastic slip that was carried into the step that has begun: `count` numbers, as `fmc_context_slip` writes
/// them.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_LENGTH` for another count than `dim` times the
/// number of facets, `FMC_ERROR_NON_FINITE_SLIP`, `FMC_ERROR_BUSY`; the old slip then stays. Threads: one call at a
/// time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_slip(context: *mut fmc_context, slip: *const f64, count: usize) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` numbers.
        unsafe {
            write(context, |state| {
                let (slip, expected) =
                    (slice("slip", slip, count, 1)?, in_either!(&state.session, one => one.slip())?.len());
                if count != expected {
                    let text = format!("'slip' has {count} numbers, and {expected} are expected: dim for every facet");
                    return Err(Failure::new(FMC_ERROR_LENGTH, text));
                }
                in_either!(&mut state.session, one => one.set_slip(slip))
            })
        }
    })
}
