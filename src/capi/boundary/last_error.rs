//! The text of the last failure.

use super::entry::quietly;
use super::failure::last_text;
use std::ffi::c_char;

/// Text of the last call that failed on this thread, "" if none did; never NULL. It names the offending indices.
///
/// The text is valid until the next call fails on this thread; successful calls do not change it. Threads: each has its
/// own.
#[unsafe(no_mangle)]
pub extern "C" fn fmc_last_error() -> *const c_char {
    quietly(c"".as_ptr(), last_text)
}
