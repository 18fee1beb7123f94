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
}

impl Failure {
    pub(crate) fn new(status: fmc_status, text: impl Into<String>) -> Self {
        Self { status, text: text.into() }
    }

    /// In the numbering of the host, whose first node and first cell is `index_base`.
    pub(crate) fn counted_from(index_base: i32) -> impl Fn(Error) -> Failure {
        move |error| {
            let counted = renumbered(error.clone(), index_base as usize);
            let note = if index_base != 0 && counted != error { ", counted from 1" } else { "" };
            Failure::new(fmc_status::from(&counted), format!("{counted}{note}"))
        }
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Failure::new(fmc_status::from(&error), error.to_string())
    }
}

/// The error with its nodes, cells and facets counted from `base`; a node out of range is named as given already.
fn renumbered(mut error: Error, base: usize) -> Error {
    match &mut error {
        Error::NodeOutOfRange { cell, .. }
        | Error::InvertedCell { cell }
        | Error::FoldedCell { cell, .. }
        | Error::ZeroMeasure { cell } => *cell += base,
        Error::NonFiniteCoordinate { node, .. }
        | Error::NotPositiveMass { node, .. }
        | Error::NegativeRadius { node, .. } => *node += base,
        Error::UnknownOutOfRange { row, .. } => *row += base,
        Error::NonConforming { cells } => cells.iter_mut().for_each(|cell| *cell += base),
        Error::RepeatedNode { cell, node } => {
            *cell += base;
            *node += base;
        }
        Error::OpenSurface { facet, nodes }
        | Error::NonManifold { facet, nodes }
        | Error::InconsistentOrientation { facet, nodes } => {
            *facet += base;
            nodes.iter_mut().for_each(|node| *node += base);
        }
        _ => {}
    }
    error
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
        assert_eq!(Failure::counted_from(1)(Error::Empty).text, "there are no cells and no facets");
    }
}
