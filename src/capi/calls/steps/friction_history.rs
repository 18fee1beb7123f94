//! What laws of friction of the host keep, for a restart.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::slice;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};

/// The history of the host's laws of friction after the accepted steps (`fmc_context_commit_step`). For each row of `fmc_context_slip`, in
/// its order, it has as many numbers as the law of its pair, none without a law. A restart needs it and the slip.
///
/// `count` becomes their number; `history` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_NO_STEP`, `FMC_ERROR_BUSY`; no output is then written.
/// Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_friction_history(
    context: *const fmc_context,
    history: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, and room for `capacity` numbers.
        unsafe {
            let found = in_either!(&read(context)?.session, one => one.friction_history())?;
            room.write("numbers of the history", "history", &found, history)
        }
    })
}

/// Sets this history, for a restart: `count` numbers, as `fmc_context_friction_history` writes them. Call it after `fmc_context_set_slip`
/// with the rows to which they belong.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for a wrong `count`, `FMC_ERROR_NOT_POSITIVE` for a number that is not
/// finite, `FMC_ERROR_NO_STEP`, `FMC_ERROR_BUSY`; the old history is then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_friction_history(
    context: *mut fmc_context,
    history: *const f64,
    count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` numbers.
        unsafe {
            write(context, |state| {
                let history = slice("history", history, count, 1)?;
                in_either!(&mut state.session, one => one.set_friction_history(history))
            })
        }
    })
}
