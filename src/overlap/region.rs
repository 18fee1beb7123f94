//! Where two bodies can overlap, found from their facets.

use super::side::FacetSide;
use crate::geometry::aabb::Aabb;
use crate::geometry::cover_count;

/// Rounds of trimming. Two find the lens of two balls; more are for curved slots.
const ROUNDS: usize = 3;

/// A slab thinner than this part of the region is not worth an inside test.
const WORTHWHILE: f64 = 0.1;

/// A box around the overlap of two bodies, or `None` if they cannot overlap. It is a function of the two bodies
/// without regard to their order, and it does not influence any result: it only bounds the work.
pub(crate) fn common_region<const D: usize>(a: &FacetSide<D>, b: &FacetSide<D>) -> Option<Aabb<D>> {
    let mut region = a.aabb.intersection(&b.aabb);
    for _ in 0..ROUNDS {
        if region.is_empty() {
            return None;
        }
        let trimmed = trim(a, &region)?.intersection(&trim(b, &region)?);
        if trimmed == region {
            break;
        }
        region = trimmed;
    }
    (!region.is_empty()).then_some(region)
}

/// Cuts slabs off `region` that lie outside the body; `None` if all of it does.
///
/// Between the facets' box and a side of the region there is no facet: such a slab is all inside or all outside, and
/// one point tells.
pub(crate) fn trim<const D: usize>(side: &FacetSide<D>, region: &Aabb<D>) -> Option<Aabb<D>> {
    let mut facets = Aabb::empty();
    for facet in 0..side.facets.len() {
        let piece = side.facet_box(facet).intersection(region);
        if !piece.is_empty() {
            facets = facets.union(&piece);
        }
    }
    let outside = |slab: &Aabb<D>| cover_count(side.facets, &side.views.points, &slab.center()) == 0;
    if facets.is_empty() {
        return (!outside(region)).then_some(*region);
    }
    let mut trimmed = *region;
    for axis in 0..D {
        let worthwhile = WORTHWHILE * region.extent()[axis];
        let mut low = trimmed;
        low.max[axis] = facets.min[axis];
        if low.extent()[axis] > worthwhile && outside(&low) {
            trimmed.min[axis] = facets.min[axis];
        }
        let mut high = trimmed;
        high.min[axis] = facets.max[axis];
        if high.extent()[axis] > worthwhile && outside(&high) {
            trimmed.max[axis] = facets.max[axis];
        }
    }
    Some(trimmed)
}
