//! A pair as seen along directions.

use crate::overlap::pair::sides::Pair;

/// A pair whose facets are projected along the directions of its patches.
pub(crate) struct ProjectedPair<'a, const D: usize> {
    pub(crate) pair: &'a Pair<'a, D>,
}
