//! A fiber to look at.

use crate::ranks::packed;

/// A fiber, to look at: where it runs and where it crosses.
#[derive(Clone, Debug, PartialEq)]
pub struct FiberTrace<const D: usize> {
    /// Start of the piece shown.
    pub start: [f64; D],
    /// End of the piece shown.
    pub end: [f64; D],
    /// Points at which spans begin and end.
    pub crossings: Vec<[f64; D]>,
}

packed!(FiberTrace<D> { start, end, crossings });
