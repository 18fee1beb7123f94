//! Sums over the contact points at every node of the mesh.

use super::contact_points::ContactPoints;
use super::facet_sums::facet_sums;
use crate::overlap::pair::sides::Pair;

/// What the contact points on the facets around a node add up to, each by the node's shape function N there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NodalSum {
    pub(crate) node: u32,
    /// ∫ N dA over the part of the facets that is in contact.
    pub(crate) area: f64,
    /// ∫ N p dA.
    pub(crate) pressure: f64,
    /// ∫ N L dA.
    pub(crate) penetration: f64,
}

/// The sums at the nodes of a pair.
#[derive(Clone, Debug)]
pub(crate) struct NodalSums {
    pub(crate) sums: Vec<NodalSum>,
    /// The largest pressure of the law anywhere: no mean of it is larger.
    pub(crate) largest_pressure: f64,
    /// Whether areas are exact, and not counted by lines.
    pub(crate) is_exact: bool,
}

impl<const D: usize> ContactPoints<D> {
    /// The sums of all nodes that have contact points around them, ascending; `pressure` is a function of the
    /// penetration.
    pub(crate) fn nodal_sums(
        &self,
        pair: &Pair<D>,
        pressure: &(dyn Fn(f64) -> f64 + Sync),
        is_exact: bool,
    ) -> NodalSums {
        let of = |slope: &(dyn Fn(f64) -> f64 + Sync)| facet_sums(pair, &self.patches.directions, &self.points, slope);
        let (pressures, penetrations) = pair.both(|| of(pressure), || of(&|length| length));
        let mut sums = Vec::new();
        for (p, l) in pressures.iter().zip(&penetrations) {
            // An obstacle has no nodes.
            if p.of_b && pair.pose.is_some() {
                continue;
            }
            for (corner, &vertex) in pair.side(p.of_b).facets[p.facet as usize].iter().enumerate() {
                pair.surface.nodes_of_vertex(vertex).for_each(|(node, part)| {
                    let [area, pressure, penetration] =
                        [p.volume[corner], p.energy[corner], l.energy[corner]].map(|sum| part * sum);
                    sums.push(NodalSum { node, area, pressure, penetration });
                });
            }
        }
        // Stable: facets are added in their order.
        sums.sort_by_key(|sum| sum.node);
        sums.dedup_by(|next, sum| {
            let same = next.node == sum.node;
            if same {
                sum.area += next.area;
                sum.pressure += next.pressure;
                sum.penetration += next.penetration;
            }
            same
        });
        let largest_pressure = self.points.iter().map(|point| pressure(point.length)).fold(0.0, f64::max);
        NodalSums { sums, largest_pressure, is_exact }
    }
}
