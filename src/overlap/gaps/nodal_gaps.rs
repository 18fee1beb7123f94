//! Weighted gaps of the nodes of one side over the surface of the other.

use super::facet_gaps::{FacetGap, facet_gap};
use super::near_surface::NearSurface;
use crate::Error;
use crate::geometry::Vector;
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::sides::Pair;
use std::collections::BTreeMap;

/// Facets that a thread takes at once.
const CHUNK: usize = 64;

/// The weighted gap of a node, and its derivative.
#[derive(Clone, Debug)]
pub(crate) struct NodalGap<const D: usize> {
    pub(crate) node: u32,
    /// Whether the node is of the second side.
    pub(crate) of_b: bool,
    /// ∫ N φ dA over what is within reach and faces the other side, φ being the distance from its surface, negative inside.
    pub(crate) gap: f64,
    /// ∫ N dA over the same part.
    pub(crate) area: f64,
    /// ∫ N ∇φ dA over it: away from the other side.
    pub(crate) away: Vector<D>,
    /// ∂gap/∂x of nodes, ascending.
    pub(crate) gradient: Vec<(u32, Vector<D>)>,
}

/// Gaps of the nodes of both sides that have a part nearer than `reach` on one of their facets, by side and by node; an
/// obstacle has no nodes, and a body has no gaps over itself.
///
/// # Errors
/// [`Error::SignedDistance`] where a function of the host fails.
pub(crate) fn nodal_gaps<const D: usize>(pair: &Pair<D>, reach: f64) -> Result<Vec<NodalGap<D>>, Error> {
    if pair.is_own() {
        return Ok(Vec::new());
    }
    let mut found = of_side(pair, false, reach)?;
    if pair.pose.is_none() {
        found.extend(of_side(pair, true, reach)?);
    }
    Ok(found)
}

fn of_side<const D: usize>(pair: &Pair<D>, of_b: bool, reach: f64) -> Result<Vec<NodalGap<D>>, Error> {
    let side = pair.side(of_b);
    let surface = NearSurface::of(pair, !of_b, reach);
    let of_facets = |numbers: &[u32]| -> Result<Vec<(BodyFacet<D>, FacetGap<D>)>, Error> {
        let parts = pair.on_threads(numbers, CHUNK, |numbers| {
            let of_contact = numbers.iter().filter(|&&number| !pair.is_tied(of_b, number));
            let facets = of_contact.filter_map(|&number| BodyFacet::new(pair.surface, side, number));
            facets.map(|facet| facet_gap(pair, (&facet, of_b), &surface).map(|gap| (facet, gap))).collect()
        });
        let parts: Vec<Vec<_>> = parts.into_iter().collect::<Result<_, _>>()?;
        Ok(parts.into_iter().flatten().collect())
    };
    let mut nodes: BTreeMap<u32, NodalGap<D>> = BTreeMap::new();
    for (facet, found) in of_facets(&surface.facets_opposite())? {
        if !found.is_near {
            continue;
        }
        for (row, &node) in facet.nodes.iter().enumerate() {
            let none = || NodalGap { node, of_b, gap: 0.0, area: 0.0, away: Vector::zeros(), gradient: Vec::new() };
            let sum = nodes.entry(node).or_insert_with(none);
            for corner in 0..D {
                let weight = facet.weights[corner][row];
                sum.gap += weight * found.gaps[corner];
                sum.area += weight * found.areas[corner];
                sum.away += found.away[corner] * weight;
                if weight != 0.0 {
                    sum.gradient.extend(found.gradients[corner].iter().map(|(node, slope)| (*node, slope * weight)));
                }
            }
        }
    }
    Ok(nodes.into_values().map(NodalGap::merged).collect())
}

impl<const D: usize> NodalGap<D> {
    /// One entry for every node of the gradient, summed in the order of the facets.
    fn merged(mut self) -> Self {
        self.gradient.sort_by_key(|(node, _)| *node);
        self.gradient.dedup_by(|next, sum| {
            let same = next.0 == sum.0;
            if same {
                sum.1 += next.1;
            }
            same
        });
        self
    }
}
