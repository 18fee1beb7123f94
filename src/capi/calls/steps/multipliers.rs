//! Multipliers, for a restart.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::slice;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::multiplier::fmc_multiplier;

/// The multipliers, ascending by node and partner. A restart, or a repeated load step, needs them and the coordinates.
///
/// `count` becomes their number; `rows` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_BUSY`. Threads: several at once on one
/// context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_multipliers(
    context: *const fmc_context,
    rows: *mut fmc_multiplier,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, and room for `capacity` structs.
        unsafe {
            let state = read(context)?;
            room.write(
                "multipliers",
                "rows",
                &in_either!(&state.session, one => one.multipliers(state.index_base)),
                rows,
            )
        }
    })
}

/// Sets the multipliers, `count` structs as `fmc_context_multipliers` writes them; none: surfaces are no longer shifted.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_NODE_OUT_OF_RANGE`, `FMC_ERROR_BAD_VALUE` for a kind of
/// partner that does not exist, `FMC_ERROR_NOT_POSITIVE` for an invalid shift or direction, `FMC_ERROR_UNSUPPORTED` as
/// `fmc_context_augment`, `FMC_ERROR_BUSY`; the old multipliers are then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_multipliers(
    context: *mut fmc_context,
    rows: *const fmc_multiplier,
    count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` structs.
        unsafe {
            write(
                context,
                |state| in_either!(&mut state.session, one => one.set_multipliers(slice("rows", rows, count, 1)?, state.index_base)),
            )
        }
    })
}
