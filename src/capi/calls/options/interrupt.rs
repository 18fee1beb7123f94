//! The end of a call that takes long, as the host wishes.

use crate::Asked;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, write};
use std::ffi::c_void;

/// Returns whether to end the running call: 0 to go on. `user` is the pointer given with it.
///
/// It is called on the thread that called the library. It must not call a function of the same context, throw, or jump out.
pub type fmc_interrupt_callback = Option<unsafe extern "C" fn(user: *mut c_void) -> i32>;

/// What a host gave.
#[derive(Clone, Copy)]
struct Host {
    callback: unsafe extern "C" fn(user: *mut c_void) -> i32,
    user: *mut c_void,
}

// SAFETY: the pointer is handed through, never followed; the host promises in `fmc_context_set_interrupt` that the callback may be called
// from whichever thread calls the library.
unsafe impl Send for Host {}
// SAFETY: as above.
unsafe impl Sync for Host {}

impl Host {
    fn is_asked(&self) -> bool {
        // SAFETY: the host gave a function that keeps to its contract, and its own pointer.
        unsafe { (self.callback)(self.user) != 0 }
    }
}

/// Sets a callback that the library asks some twenty times a second, during a call, whether to end the call; NULL, the default:
/// none.
///
/// An interrupted call returns `FMC_ERROR_INTERRUPTED`; the context is unchanged, and remains usable. A search for an equilibrium then
/// ends with a refusal. The library calls it while it measures pairs. It does not call it within a factorisation or the linear algebra of
/// a contact step, nor while ranks share the work, since they would wait for one another.
///
/// The callback and `user` must outlive the context, or be replaced before they end. Errors: `FMC_ERROR_NULL_POINTER`,
/// `FMC_ERROR_UNSUPPORTED` for a mesh in parts, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_interrupt(
    context: *mut fmc_context,
    callback: fmc_interrupt_callback,
    user: *mut c_void,
) -> fmc_status {
    entry(|| {
        let asked = callback.map(|callback| {
            let host = Host { callback, user };
            Box::new(move || host.is_asked()) as Asked
        });
        // SAFETY: the host passes a context.
        unsafe {
            write(context, |state| {
                in_either!(&mut state.session, one => one.contact_mut()?.set_interrupt(asked));
                Ok(())
            })
        }
    })
}
