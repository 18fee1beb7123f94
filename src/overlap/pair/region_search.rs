//! Where two bodies can overlap, found from their facets.

use super::obstacle_region;
use super::region::Region;
use super::sides::{Counterpart, Pair};
use crate::Error;
use crate::configuration::FacetSide;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::{Piece, clip_to_box};

/// Rounds of trimming. Two find the lens of two balls; more are for curved slots.
const ROUNDS: usize = 3;

/// A slab thinner than this part of the region is not tested for being inside.
const WORTHWHILE: f64 = 0.1;

impl<const D: usize> Pair<'_, D> {
    /// Where the two sides can overlap, or `None` if they cannot. Results do not depend on how closely it is found, but
    /// for the automatic spacing of lines. It is found once for the pair.
    pub(crate) fn region(&self) -> Result<Option<&Region<D>>, Error> {
        if let Some(known) = self.region.get() {
            return Ok(known.as_ref());
        }
        let found = match &self.counterpart {
            Counterpart::Itself => region_of(&self.a, &self.a.aabb),
            Counterpart::Facets(b) => common_region(&self.a, b),
            Counterpart::Implicit(side) => {
                obstacle_region::region(side, &self.a.aabb)?.and_then(|within| region_of(&self.a, &within))
            }
        };
        Ok(self.region.get_or_init(|| found).as_ref())
    }

    /// Whether the winding numbers of both sides are known to be nowhere negative in their region.
    pub(crate) fn is_upright(&self, region: &Region<D>) -> bool {
        let Region { aabb, facets, is_upright, .. } = region;
        *is_upright.get_or_init(|| match &self.counterpart {
            Counterpart::Facets(b) => self.a.is_upright_in(&facets[0], aabb) && b.is_upright_in(&facets[1], aabb),
            Counterpart::Itself | Counterpart::Implicit(_) => self.a.is_upright,
        })
    }
}

/// The region of two bodies, or `None` if they cannot overlap. Its box is a function of the two bodies without regard
/// to their order, and it does not influence any result but the automatic spacing: it bounds the work.
fn common_region<const D: usize>(a: &FacetSide<D>, b: &FacetSide<D>) -> Option<Region<D>> {
    let mut aabb = a.aabb.intersection(&b.aabb);
    if is_flat(&aabb) {
        return None;
    }
    // Facets that coincide but for rounding must both be found.
    aabb = aabb.inflated(aabb.rounding());
    let mut facets = [a.facets_in(&aabb), b.facets_in(&aabb)];
    for _ in 0..ROUNDS {
        let trimmed = trim(a, &mut facets[0], &aabb)?.intersection(&trim(b, &mut facets[1], &aabb)?);
        if trimmed.is_empty() {
            return None;
        }
        if trimmed == aabb {
            break;
        }
        aabb = trimmed;
    }
    for (side, facets) in [a, b].iter().zip(&mut facets) {
        facets.retain(|&f| side.facet_box(f as usize).meets(&aabb));
    }
    Some(Region::new(aabb, facets))
}

/// The part of `within` that one body reaches, and its facets there; `None` if it does not.
fn region_of<const D: usize>(side: &FacetSide<D>, within: &Aabb<D>) -> Option<Region<D>> {
    if is_flat(within) {
        return None;
    }
    let mut facets = side.facets_in(within);
    let aabb = trim(side, &mut facets, within)?;
    facets.retain(|&f| side.facet_box(f as usize).meets(&aabb));
    Some(Region::new(aabb, [facets, Vec::new()]))
}

/// Whether a region is empty or thinner than rounding: bodies that meet there touch and do not overlap.
fn is_flat<const D: usize>(region: &Aabb<D>) -> bool {
    region.is_empty() || region.extent().min() <= region.rounding()
}

/// Cuts slabs off `region` that lie outside the body; `None` if all of it does. `facets` is reduced to those that meet
/// the region.
///
/// Between the facets' box and a side of the region there is no facet: such a slab is all inside or all outside, and
/// one point tells.
fn trim<const D: usize>(side: &FacetSide<D>, facets: &mut Vec<u32>, region: &Aabb<D>) -> Option<Aabb<D>> {
    let (mut bounds, mut piece) = (Aabb::empty(), Piece::default());
    facets.retain(|&facet| {
        let aabb = side.facet_box(facet as usize);
        if region.contains(&aabb) {
            bounds = bounds.union(&aabb);
            return true;
        }
        let meets = aabb.meets(region);
        if meets {
            // A large facet may only cut a corner of the region.
            bounds = bounds.union(&clip_to_box(&side.corners(facet as usize), region, &mut piece));
        }
        meets
    });
    let bounds = bounds.inflated(region.rounding()).intersection(region);
    let outside = |slab: &Aabb<D>| side.winding_number(&slab.center()) == 0;
    if bounds.is_empty() {
        return (!outside(region)).then_some(*region);
    }
    let mut trimmed = *region;
    for axis in 0..D {
        let worthwhile = WORTHWHILE * region.extent()[axis];
        let mut low = trimmed;
        low.max[axis] = bounds.min[axis];
        if low.extent()[axis] > worthwhile && outside(&low) {
            trimmed.min[axis] = bounds.min[axis];
        }
        let mut high = trimmed;
        high.min[axis] = bounds.max[axis];
        if high.extent()[axis] > worthwhile && outside(&high) {
            trimmed.max[axis] = bounds.max[axis];
        }
    }
    Some(trimmed)
}
