//! Points at which facets inside the other side are pressed.

use super::bodies::CellPieces;
use super::integral::depth_integral;
use crate::Error;
use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::convex_piece::place;
use crate::overlap::depth_integral::{FacetDepth, SecondDerivative};
use crate::overlap::depth_points::{DepthPoint, PlaceInCell};
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::region::common_region;
use crate::overlap::pair::sides::{Counterpart, Pair};

/// Barycentric coordinates above this are inside but for rounding.
const INSIDE: f64 = -1e-9;

/// One point for every facet that is pressed, by side and by facet.
///
/// # Errors
/// As [`depth_integral`].
pub(crate) fn depth_points<const D: usize>(pair: &Pair<D>) -> Result<Vec<DepthPoint<D>>, Error> {
    let Some(integral) = depth_integral(pair, SecondDerivative::No, 0)? else { return Ok(Vec::new()) };
    let others = other_pieces(pair);
    let own_cell = |facet: u32| match (pair.is_own(), pair.partners[0]) {
        (true, Partner::Body(body)) => Some(pair.surface.facet_cell[pair.surface.ranges[body].start + facet as usize]),
        _ => None,
    };
    Ok(integral.facets.iter().filter_map(|found| of_facet(pair, &others, own_cell(found.facet), found)).collect())
}

/// The cells in which facets of the first side lie, and those of the second.
fn other_pieces<const D: usize>(pair: &Pair<D>) -> Vec<CellPieces<D>> {
    let (Some(field), Some(cells)) = (pair.depth, &pair.surface.cells) else { return Vec::new() };
    let pieces = |which: usize, facets: &[u32], aabb: &Aabb<D>| {
        let Partner::Body(body) = pair.partners[which] else { return None };
        Some(CellPieces::new(pair.surface, cells, field, pair.coords, body, facets, aabb))
    };
    match &pair.counterpart {
        Counterpart::Itself => pieces(0, &[], &pair.a.aabb).into_iter().collect(),
        Counterpart::Facets(b) => {
            let Some(region) = common_region(&pair.a, b) else { return Vec::new() };
            [1, 0].into_iter().filter_map(|k| pieces(k, &region.facets[k], &region.aabb)).collect()
        }
        Counterpart::Implicit(_) => Vec::new(),
    }
}

fn of_facet<const D: usize>(
    pair: &Pair<D>,
    others: &[CellPieces<D>],
    own_cell: Option<u32>,
    found: &FacetDepth<D>,
) -> Option<DepthPoint<D>> {
    let (area, total): (f64, f64) = (found.areas.iter().sum(), found.depths.iter().sum());
    if area <= 0.0 || total <= 0.0 {
        return None;
    }
    let side = pair.side(found.of_b);
    let facet = BodyFacet::new(pair.surface, side, found.facet)?;
    let weights = found.depths.map(|depth| depth / total);
    let other = match (others, found.of_b) {
        _ if pair.pose.is_some() => None,
        ([all], _) => Some(all),
        ([second, _], false) => Some(second),
        ([_, first], true) => Some(first),
        _ => None,
    };
    Some(DepthPoint {
        of_b: found.of_b,
        facet: found.facet,
        weights,
        normal: facet.normal.into(),
        depth: total / area,
        area: found.weight * area,
        other: other.and_then(|pieces| pieces.locate(&place(&facet.corners, &weights), side.aabb.rounding(), own_cell)),
    })
}

impl<const D: usize> CellPieces<D> {
    /// The cell that a point lies in, the one whose faces it is farthest from; not in the cell `without`.
    fn locate(&self, x: &Vector<D>, rounding: f64, without: Option<u32>) -> Option<PlaceInCell> {
        let (aabb, mut best) = (Aabb::of(&[*x]).inflated(rounding), None);
        let mut farthest = INSIDE;
        self.tree.visit(
            |node| node.meets(&aabb),
            |j| {
                let piece = &self.pieces[j as usize];
                let at = piece.barycentric(x);
                let least = at[..=D].iter().fold(f64::INFINITY, |least, b| least.min(*b));
                if least > farthest && without != Some(piece.cell) {
                    farthest = least;
                    best = Some(PlaceInCell { cell: piece.cell, weights: piece.at_nodes(&at) });
                }
            },
        );
        best
    }
}
