//! The points of which hosts are told, as combinations of their nodes.

use crate::geometry::Surface;
use crate::geometry::second_order::Division;

/// P, by which points X = P x come from nodes x: in compressed rows, one for every point.
///
/// Cells of second order are divided into straight ones, whose points are fixed linear combinations of the nodes. Wherever a
/// number of a point is told ([`BoundaryFacet::nodes`](crate::geometry::BoundaryFacet::nodes),
/// [`SideOfPoint::nodes`](crate::contact::SideOfPoint::nodes), [`GapConstraints::nodes`](crate::contact::GapConstraints::nodes))
/// it is that of a row. Values at nodes are brought to points by P; forces, and what else is a derivative, from points to nodes
/// by Pᵀ. A point that is a node, or stands for one in the middle of an edge, face or cell, has the node's number; the
/// middles of faces without a node come after the nodes. Without cells of second order P is the identity.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointWeights {
    /// Entries of point p: `starts[p]..starts[p + 1]`; one number more than there are points.
    pub starts: Vec<usize>,
    /// Node of every entry, each node once in a row.
    pub nodes: Vec<u32>,
    /// Its weight. The weights of a row add up to 1 (with a basis to what its rows do); some are negative.
    pub weights: Vec<f64>,
}

impl PointWeights {
    /// Number of points, at least that of the nodes.
    pub fn point_count(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// Nodes that move a point, with their weights.
    ///
    /// # Panics
    /// If there is no such point.
    pub fn row(&self, point: usize) -> impl Iterator<Item = (u32, f64)> {
        let entries = self.starts[point]..self.starts[point + 1];
        self.nodes[entries.clone()].iter().copied().zip(self.weights[entries].iter().copied())
    }
}

impl<const D: usize> Surface<D> {
    /// The points of which hosts are told, as combinations of nodes.
    #[inline(never)]
    pub fn point_weights(&self) -> PointWeights {
        let mut all = PointWeights { starts: vec![0], ..PointWeights::default() };
        let mut add = |row: &mut dyn Iterator<Item = (u32, f64)>| {
            for (node, weight) in row {
                all.nodes.push(node);
                all.weights.push(weight);
            }
            all.starts.push(all.nodes.len());
        };
        match self.division().map(Division::map) {
            Some(map) => (0..map.point_count()).for_each(|point| add(&mut map.row(point))),
            None => (0..self.node_count() as u32).for_each(|node| add(&mut [(node, 1.0)].into_iter())),
        }
        all
    }
}
