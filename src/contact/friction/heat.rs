//! Where the energy that friction dissipates becomes heat.

use super::carried::CarriedSlip;
use super::slip_facets::SlipFacets;
use crate::geometry::Surface;
use crate::overlap::Partner;

impl<const D: usize> SlipFacets<D> {
    /// Calls `add(node, heat)`, an obstacle being a node after those of the mesh: the energy dissipated on every facet goes to the nodes that
    /// move it and those that move what it faces, `of_first` of it to the first side. Energy of facets that have left the contact goes to
    /// those that are in it.
    pub(crate) fn heat(&self, of_first: f64, mut add: impl FnMut(u32, f64)) {
        let area: f64 = self.facets.iter().map(|facet| facet.area).sum();
        let released = self.released();
        for (facet, rows, traction) in self.tractions() {
            let energy = facet.area * (facet.dissipated(&traction) + released / area);
            let of_side = |of_b: bool| {
                let weights = rows.iter().filter(move |row| row.of_b == of_b && !row.mover.turns);
                // A row is the shape function of its node, and negative on the second side.
                weights.map(|row| (row.mover.node, row.slip.trace().abs()))
            };
            for (of_b, part) in [(false, of_first), (true, 1.0 - of_first)] {
                let sum: f64 = of_side(of_b).map(|(_, weight)| weight).sum();
                of_side(of_b).for_each(|(node, weight)| add(node, energy * part * weight / sum));
            }
        }
    }
}

/// The same of a pair that has left the contact with this energy: by the elastic slip that its facets had carried, and to these alone.
pub(crate) fn heat_of_released<const D: usize>(
    (pair, energy): ([Partner; 2], f64),
    carried: &CarriedSlip<D>,
    surface: &Surface<D>,
    mut add: impl FnMut(u32, f64),
) {
    let of_pair = || carried.range((pair, false, 0)..=(pair, true, usize::MAX));
    let squares: f64 = of_pair().map(|(_, carried)| carried.slip.norm_squared()).sum();
    for ((_, _, facet), carried) in of_pair() {
        let part = carried.slip.norm_squared() / squares / D as f64;
        for (node, weight) in surface.facets[*facet].iter().flat_map(|&vertex| surface.nodes_of_vertex(vertex)) {
            add(node, energy * part * weight);
        }
    }
}
