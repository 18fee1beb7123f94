//! How a context ends.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::state::fmc_context;

/// Frees a context and sets the host's pointer to NULL. Does nothing for a NULL pointer, or a pointer to NULL.
///
/// Errors: none. Threads: no other call on the context may be running or follow.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_free(context: *mut *mut fmc_context) -> fmc_status {
    entry(|| {
        if context.is_null() {
            return Ok(());
        }
        // SAFETY: the host passes its pointer to a context that came from `create`, or to NULL; it is taken out, so
        // that a second call finds NULL.
        let taken = unsafe { context.replace(std::ptr::null_mut()) };
        if !taken.is_null() {
            // SAFETY: made by `Box::into_raw` in `create`, and not freed yet, or the pointer would have been NULL.
            drop(unsafe { Box::from_raw(taken) });
        }
        Ok(())
    })
}
