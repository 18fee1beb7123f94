//! History of interfaces that follow a law of the host, for a restart.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::Room;
use crate::capi::boundary::pointer::slice;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};

/// The history of all points of interfaces by laws of the host after the accepted steps (`fmc_context_commit_step`), in the order of
/// `fmc_context_law_points`: as many numbers for each as its law has. A restart needs it and the coordinates.
///
/// `count` becomes their number; `history` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_UNTIED` as `fmc_context_law_points`, `FMC_ERROR_BUSY`;
/// no output is then written. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_law_history(
    context: *const fmc_context,
    history: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, and room for `capacity` numbers.
        unsafe {
            let found = in_either!(&read(context)?.session, one => one.law_history())?;
            room.write("numbers of the history", "history", &found, history)
        }
    })
}

/// Sets this history: `count` numbers, as `fmc_context_law_history` writes them, for a restart.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_LENGTH` for a wrong `count`, `FMC_ERROR_NOT_POSITIVE` for a number that is not
/// finite, `FMC_ERROR_UNTIED`, `FMC_ERROR_BUSY`; the old history is then kept. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_law_history(
    context: *mut fmc_context,
    history: *const f64,
    count: usize,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context and `count` numbers.
        unsafe {
            write(context, |state| {
                let history = slice("history", history, count, 1)?;
                in_either!(&mut state.session, one => one.set_law_history(history))
            })
        }
    })
}
