//! Facets that lines through the overlap may meet.

use super::projected_pair::ProjectedPair;
use crate::Error;
use crate::configuration::FacetSide;
use crate::overlap::pair::sides::Counterpart;
use std::borrow::Cow;

/// Facets of either side that lines through the overlap may meet.
pub(crate) struct Reached<'a> {
    pub(crate) facets: Cow<'a, [Vec<u32>; 2]>,
    /// Distance that is rounding there.
    pub(crate) rounding: f64,
    /// Whether the winding numbers of both sides are known to be nowhere negative there.
    pub(crate) is_upright: bool,
}

impl<const D: usize> ProjectedPair<'_, D> {
    /// `None` where the sides are apart.
    pub(crate) fn reached_facets(&self) -> Result<Option<Reached<'_>>, Error> {
        let Some(region) = self.pair.region()? else { return Ok(None) };
        let rounding = region.aabb.rounding();
        let is_upright = self.pair.is_upright(region);
        let a = &self.pair.a;
        let facets = match &self.pair.counterpart {
            // All that lines meet beyond the region tells how often they were inside before.
            Counterpart::Facets(b) if !is_upright => {
                let common = a.aabb.intersection(&b.aabb);
                let common = common.inflated(common.rounding());
                Cow::Owned([a.facets_in(&common), b.facets_in(&common)])
            }
            Counterpart::Facets(b) => {
                let bounds = self.pair.bounds(region);
                let held = |side: &FacetSide<D>, facets: &[u32]| -> Vec<u32> {
                    let may_hold = |facet: u32| bounds.may_hold(side.corners(facet as usize).into_iter());
                    facets.iter().copied().filter(|&facet| may_hold(facet)).collect()
                };
                Cow::Owned([held(a, &region.facets[0]), held(b, &region.facets[1])])
            }
            Counterpart::Itself | Counterpart::Implicit(_) => Cow::Borrowed(&region.facets),
        };
        Ok(Some(Reached { facets, rounding, is_upright }))
    }
}
