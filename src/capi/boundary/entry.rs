//! The panic boundary. Nothing unwinds into the host, and nothing is printed.
//!
//! A panic runs the process-wide panic hook before it unwinds, and the default hook prints. There is no hook per
//! thread, so the first entry replaces it, once, by one that is silent for panics inside an entry and for the threads
//! of this module, and that hands every other panic to the hook it found. In a C, Fortran or Python process the
//! library's hook is its own; in a Rust process that links the static library, panics of others print as before.

use super::failure::{Failure, remember};
use super::status::fmc_status;
use std::any::Any;
use std::cell::{Cell, RefCell};
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

/// Worker threads carry this in front of their names.
const THREAD_NAME: &str = "fmc-contact";

thread_local! {
    /// How many entries this thread is inside of; more than one when a callback calls in again.
    static DEPTH: Cell<usize> = const { Cell::new(0) };
    /// Where the last panic of this thread was raised; the hook learns it, the boundary reports it.
    static PLACE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Lowers the depth again, also when the entry unwinds.
struct Inside;

impl Inside {
    fn enter() -> Self {
        let _ = DEPTH.try_with(|depth| depth.set(depth.get() + 1));
        Inside
    }
}

impl Drop for Inside {
    fn drop(&mut self) {
        let _ = DEPTH.try_with(|depth| depth.set(depth.get() - 1));
    }
}

/// Whether this thread is inside an entry, or a worker of this module.
fn is_ours() -> bool {
    DEPTH.try_with(|depth| depth.get() > 0).unwrap_or(false)
        || std::thread::current().name().is_some_and(|name| name.starts_with(THREAD_NAME))
}

fn install_hook() {
    static INSTALLED: Once = Once::new();
    INSTALLED.call_once(|| {
        let previous = take_hook();
        set_hook(Box::new(move |info| {
            if !is_ours() {
                previous(info);
            } else if let Some(place) = info.location() {
                let _ = PLACE.try_with(|last| *last.borrow_mut() = format!(" at {}:{}", place.file(), place.line()));
            }
        }));
    });
}

/// What a panic said, and where; the place is not known for a panic on a worker thread.
fn sentence(payload: &(dyn Any + Send)) -> String {
    let said = payload.downcast_ref::<String>().map(String::as_str).or(payload.downcast_ref::<&str>().copied());
    let place = PLACE.try_with(RefCell::take).unwrap_or_default();
    format!("panic caught{place}: {}", said.unwrap_or("without a message"))
}

/// Runs `body` behind the boundary, with a failure for a panic.
pub(crate) fn guarded<T>(body: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
    // A thread that is panicking already (an entry called from a destructor) may not replace the hook.
    if !std::thread::panicking() {
        install_hook();
    }
    let _inside = Inside::enter();
    // Unwind safety: what `body` may leave half done is a context's state, which is replaced only when complete.
    catch_unwind(AssertUnwindSafe(body))
        .unwrap_or_else(|payload| Err(Failure::new(fmc_status::FMC_ERROR_PANIC, sentence(&*payload))))
}

/// An exported function: runs `body` behind the boundary and keeps the text of a failure for the thread.
pub(crate) fn entry(body: impl FnOnce() -> Result<(), Failure>) -> fmc_status {
    match guarded(body) {
        Ok(()) => fmc_status::FMC_OK,
        Err(failure) => {
            remember(&failure.text);
            failure.status
        }
    }
}

/// An exported function without a status: `otherwise` when it panics.
pub(crate) fn quietly<T>(otherwise: T, body: impl FnOnce() -> T) -> T {
    guarded(|| Ok(body())).unwrap_or(otherwise)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::capi::boundary::last_error::fmc_last_error;
    use std::ffi::CStr;

    fn last_error() -> String {
        // SAFETY: the text is a C string of this thread, copied before anything else fails.
        unsafe { CStr::from_ptr(fmc_last_error()) }.to_str().unwrap().to_owned()
    }

    #[test]
    fn a_panic_becomes_a_status() {
        assert_eq!(entry(|| panic!("node {} is lost", 7)), fmc_status::FMC_ERROR_PANIC);
        let place = format!("panic caught at {}:", file!());
        assert!(last_error().starts_with(&place) && last_error().ends_with(": node 7 is lost"), "{}", last_error());
        assert_eq!(entry(|| panic!("lost")), fmc_status::FMC_ERROR_PANIC);
        assert!(last_error().starts_with(&place) && last_error().ends_with(": lost"));
        assert_eq!(entry(|| std::panic::panic_any(7)), fmc_status::FMC_ERROR_PANIC);
        assert!(last_error().starts_with(&place) && last_error().ends_with(": without a message"));
        DEPTH.with(|depth| assert_eq!(depth.get(), 0));
    }

    #[test]
    fn only_our_own_panics_are_silent() {
        assert!(!is_ours());
        entry(|| {
            assert!(is_ours());
            Ok(())
        });
        let worker = std::thread::Builder::new().name(format!("{THREAD_NAME}-0")).spawn(is_ours).unwrap();
        assert!(worker.join().unwrap());
    }

    #[test]
    fn success_leaves_the_last_text_alone() {
        entry(|| Err(Failure::new(fmc_status::FMC_ERROR_EMPTY, "nothing")));
        assert_eq!(entry(|| Ok(())), fmc_status::FMC_OK);
        assert_eq!(last_error(), "nothing");
    }
}
