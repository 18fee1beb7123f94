//! Sums by the nodes of both sides, each in the order in which it was added to.

/// Of few nodes, which are found where they were last; a map of them takes most of the time of a tie.
#[derive(Default)]
pub(super) struct SumsByNode {
    /// By node, and whether it is of the side that is faced.
    pub(super) entries: Vec<((bool, u32), f64)>,
}

impl SumsByNode {
    /// `last`: where that node was found for a point of the same facets.
    pub(super) fn add(&mut self, key: (bool, u32), value: f64, last: &mut usize) {
        let is_here = |(known, _): &((bool, u32), f64)| *known == key;
        if !self.entries.get(*last).is_some_and(is_here) {
            *last = self.entries.iter().position(is_here).unwrap_or(self.entries.len());
        }
        match self.entries.get_mut(*last) {
            Some((_, sum)) => *sum += value,
            None => self.entries.push((key, 0.0 + value)),
        }
    }

    pub(super) fn sort(&mut self) {
        self.entries.sort_unstable_by_key(|(key, _)| *key);
    }
}
