//! Edges of facets as seen along the lines (2D: nodes).

use super::projected_facets::{ProjectedFacet, Projection};
use super::projected_pair::ProjectedPair;
use crate::geometry::Vector;
use crate::ranks::packed;

/// An edge as one facet has it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct EdgeSide {
    /// Its vertices, ascending, and whether it is of the second side.
    pub(crate) key: ([u32; 2], bool),
    /// Whether lines leave through the facet.
    pub(crate) leaves: bool,
    /// Number of the facet among those that are seen.
    pub(crate) facet: u32,
    /// Corners of the facet at the edge.
    pub(crate) corners: [usize; 2],
}

/// An edge between two facets of one side, as seen along the lines.
pub(crate) struct Edge<const D: usize> {
    pub(crate) of_b: bool,
    /// Before it, on the side to which ν points, and behind it.
    pub(crate) facets: [u32; 2],
    /// Unit vector across.
    pub(crate) nu: Vector<D>,
}

packed!(Edge<D> { of_b, facets, nu });

impl<const D: usize> ProjectedPair<'_, D> {
    /// All edges of the facets that are seen, the facets of one edge beside one another.
    pub(crate) fn edge_sides(&self, seen: &Projection<D>) -> Vec<EdgeSide> {
        let mut sides = Vec::with_capacity(D * seen.facets.len());
        for (index, facet) in seen.facets.iter().enumerate() {
            let vertices = self.pair.side(facet.of_b).facets[facet.facet as usize];
            for k in 0..D {
                let corners = if D == 2 { [k, k] } else { [k, (k + 1) % D] };
                let mut key = corners.map(|c| vertices[c]);
                key.sort_unstable();
                sides.push(EdgeSide { key: (key, facet.of_b), leaves: facet.leaves, facet: index as u32, corners });
            }
        }
        sides.sort_unstable();
        sides
    }
}

/// A facet at one of its edges, as seen along the lines.
pub(crate) struct Flank {
    /// Slope of t across the edge.
    pub(crate) slope: f64,
    /// Whether it lies on the side to which the vector across the edge points.
    pub(crate) is_before: bool,
}

/// Unit vector across an edge in the plane across the lines, and the two facets there; `None` where they are seen
/// edge-on.
pub(crate) fn flanks<const D: usize>(
    ends: &[[f64; 3]; 2],
    facets: [&ProjectedFacet<D>; 2],
) -> Option<([f64; 2], [Flank; 2])> {
    let [p, q] = *ends;
    let size = distance(ends);
    let across = if D == 2 { [1.0, 0.0] } else { [-(q[1] - p[1]) / size, (q[0] - p[0]) / size] };
    let flank = |facet: &ProjectedFacet<D>| {
        let away = |c: &[f64; 3]| across[0] * (c[0] - p[0]) + across[1] * (c[1] - p[1]);
        let far = facet.corners.iter().max_by(|c, e| away(c).abs().total_cmp(&away(e).abs()))?;
        // Height of the edge's line straight across from that corner.
        let run = |c: &[f64; 3]| across[1] * (c[0] - p[0]) - across[0] * (c[1] - p[1]);
        let base = if D == 2 { p[2] } else { p[2] + (q[2] - p[2]) * run(far) / run(&q) };
        let slope = (far[2] - base) / away(far);
        (slope.is_finite() && across[0].is_finite()).then_some(Flank { slope, is_before: away(far) > 0.0 })
    };
    Some((across, [flank(facets[0])?, flank(facets[1])?]))
}

/// Length of a curve across the lines.
pub(crate) fn distance(ends: &[[f64; 3]; 2]) -> f64 {
    (ends[1][0] - ends[0][0]).hypot(ends[1][1] - ends[0][1])
}

/// Place on a curve, from its first end to its last.
pub(crate) fn along(ends: &[[f64; 3]; 2], s: f64) -> [f64; 3] {
    std::array::from_fn(|i| ends[0][i] + s * (ends[1][i] - ends[0][i]))
}
