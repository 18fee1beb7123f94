//! Patches of a local law that are kept during a solve.

use crate::contact::partners::Poses;
use crate::overlap::{Partner, Patches};

/// Patches of the fiber law by pair, in the order of the pairs, and where they were found.
pub(crate) struct KeptPatches<const D: usize> {
    by_pair: Vec<([Partner; 2], Patches<D>)>,
    /// Which coordinates these were, of a mesh that is given in parts.
    pub(crate) epoch: u64,
    pub(crate) poses: Poses<D>,
}

impl<const D: usize> KeptPatches<D> {
    pub(crate) fn none() -> Self {
        Self { by_pair: Vec::new(), epoch: 0, poses: Vec::new() }
    }

    pub(crate) fn new(by_pair: Vec<([Partner; 2], Patches<D>)>, epoch: u64, poses: Poses<D>) -> Self {
        Self { by_pair, epoch, poses }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.by_pair.is_empty()
    }

    /// Number of directions.
    pub(crate) fn direction_count(&self) -> usize {
        self.by_pair.iter().map(|(_, patches)| patches.directions.len()).sum()
    }

    /// Those of a pair.
    pub(crate) fn of(&self, pair: &[Partner; 2]) -> Option<&Patches<D>> {
        self.by_pair.binary_search_by_key(pair, |(kept, _)| *kept).ok().map(|place| &self.by_pair[place].1)
    }

    /// Releases those against a partner.
    pub(crate) fn forget(&mut self, partner: Partner) {
        self.by_pair.retain(|(pair, _)| !pair.contains(&partner));
    }
}
