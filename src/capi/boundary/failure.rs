//! Why a call failed: a status and a sentence, kept for the thread.

use super::status::fmc_status;
use crate::Error;
use std::cell::RefCell;
use std::ffi::{CString, c_char};

/// Status and sentence of a failed call.
#[derive(Debug)]
pub(crate) struct Failure {
    pub(crate) status: fmc_status,
    pub(crate) text: String,
    /// What the text says, as long as its numbers are counted from 0.
    error: Option<Error>,
}

impl Failure {
    pub(crate) fn new(status: fmc_status, text: impl Into<String>) -> Self {
        Self { status, text: text.into(), error: None }
    }

    /// In the numbering of the host, whose first node and first cell is `index_base`.
    pub(crate) fn counted_from(index_base: i32) -> impl Fn(Error) -> Failure {
        move |error| Failure::from(error).in_numbers_from(index_base)
    }

    /// The same, of a failure that may be in that numbering already.
    pub(crate) fn in_numbers_from(mut self, index_base: i32) -> Self {
        if let Some(error) = self.error.take() {
            let counted = error.clone().counted_from(index_base as usize);
            // Not by the errors themselves: none with NaN equals itself.
            let counted = counted.to_string();
            if counted != error.to_string() {
                self.text = format!("{counted}, counted from {index_base}");
            }
        }
        self
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self { status: fmc_status::from(&error), text: error.to_string(), error: Some(error) }
    }
}

thread_local! {
    static LAST_ERROR: RefCell<CString> = RefCell::default();
}

/// Text for C; bytes of zero, which could only come from a host's own strings, are left out.
pub(crate) fn c_text(text: &str) -> CString {
    CString::new(text.replace('\0', "")).unwrap_or_default()
}

/// Keeps the text for `fmc_last_error`. A thread whose locals are gone already keeps nothing.
pub(crate) fn remember(text: &str) {
    let _ = LAST_ERROR.try_with(|last| *last.borrow_mut() = c_text(text));
}

/// What was kept last; "" before. Valid until the next call fails on this thread.
pub(crate) fn last_text() -> *const c_char {
    LAST_ERROR.try_with(|last| last.borrow().as_ptr()).unwrap_or(c"".as_ptr())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_count_as_the_host_does() {
        let error = Error::RepeatedNode { cell: 0, node: 4 };
        assert_eq!(Failure::counted_from(0)(error.clone()).text, "cell or facet 0 names node 4 twice");
        assert_eq!(Failure::counted_from(1)(error).text, "cell or facet 1 names node 5 twice, counted from 1");
        let not_a_number = Error::NotPositive { name: "damage", value: f64::NAN };
        assert_eq!(Failure::counted_from(0)(not_a_number).text, "'damage' is NaN, which is not allowed");
        assert_eq!(Failure::counted_from(1)(Error::Empty).text, "there are no cells and no facets");
        let once = Failure::counted_from(1)(Error::NonFiniteSlip { facet: 2 });
        assert_eq!(once.in_numbers_from(1).text, "the slip of facet 3 is not finite, counted from 1");
    }
}
