//! Processor time of the longest call of a program, where it is asked for.

use std::sync::LazyLock;
use std::sync::atomic::{AtomicI64, Ordering::Relaxed};

static IS_ASKED: LazyLock<bool> = LazyLock::new(|| std::env::var_os("FMC_FUZZ_TIMED").is_some());
static LAST: AtomicI64 = AtomicI64::new(0);
static LONGEST: AtomicI64 = AtomicI64::new(0);

unsafe extern "C" {
    /// Of C: processor time of all threads, in microseconds wherever POSIX holds.
    safe fn clock() -> std::ffi::c_long;
}

/// Before the first call.
pub fn start() {
    if *IS_ASKED {
        LAST.store(clock(), Relaxed);
        LONGEST.store(0, Relaxed);
    }
}

/// After every call.
pub(crate) fn call() {
    if *IS_ASKED {
        let now = clock();
        LONGEST.fetch_max(now - LAST.swap(now, Relaxed), Relaxed);
    }
}

/// After the last one.
pub fn tell() {
    if *IS_ASKED {
        println!("longest call: {} s", LONGEST.load(Relaxed) as f64 / 1e6);
    }
}
