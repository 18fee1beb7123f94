//! Divisions of meshes some of whose nodes are one.

use super::division::Division;
use super::interpolation::Interpolation;
use crate::geometry::mesh::weld::Welds;

impl Division {
    /// The same with the first of some nodes that are one in their mean, wherever a point comes from it.
    pub(crate) fn welded(mut self, welds: Welds, is_used: impl Fn(usize) -> bool) -> Self {
        self.interpolation = self.interpolation.welded(&welds, is_used);
        self.welds = welds;
        self
    }

    /// Nodes that are one, ascending.
    pub(crate) fn welds(&self) -> &[Vec<u32>] {
        &self.welds
    }
}

impl Interpolation {
    fn welded(&self, welds: &Welds, is_used: impl Fn(usize) -> bool) -> Self {
        let of_first = |node: u32| {
            let place = welds.binary_search_by_key(&node, |nodes| nodes[0]).ok()?;
            Some(&welds[place])
        };
        let row = |point: usize| {
            let mut row = Vec::new();
            for (node, weight) in self.row(point) {
                match of_first(node) {
                    Some(nodes) => row.extend(nodes.iter().map(|&one| (one, weight / nodes.len() as f64))),
                    None => row.push((node, weight)),
                }
            }
            row.sort_by_key(|(node, _)| *node);
            row
        };
        let rows: Vec<_> = (0..self.point_count()).map(row).collect();
        Self::new(self.node_count(), &rows, is_used)
    }
}
