//! Facets that lines through the overlap may meet.

use crate::Error;
use crate::overlap::exact::clipping::volume::ExactPair;
use crate::overlap::pair::region::Region;
use crate::overlap::pair::sides::Counterpart;

/// Facets of either side that lines through the overlap may meet.
pub(crate) struct Reached {
    pub(crate) facets: [Vec<u32>; 2],
    /// Distance that is rounding there.
    pub(crate) rounding: f64,
    /// Whether the winding numbers of both sides are known to be nowhere negative there.
    pub(crate) is_upright: bool,
}

impl<const D: usize> ExactPair<'_, D> {
    /// `None` where the sides are apart.
    pub(crate) fn reached_facets(&self) -> Result<Option<Reached>, Error> {
        let Some(Region { aabb, facets }) = self.pair.region()? else { return Ok(None) };
        let rounding = aabb.rounding();
        let a = &self.pair.a;
        let is_upright = match &self.pair.counterpart {
            Counterpart::Facets(b) => {
                let is_upright = a.is_upright_in(&facets[0], &aabb) && b.is_upright_in(&facets[1], &aabb);
                if !is_upright {
                    // All that lines meet beyond the region tells how often they were inside before.
                    let common = a.aabb.intersection(&b.aabb);
                    let common = common.inflated(common.rounding());
                    let facets = [a.facets_in(&common), b.facets_in(&common)];
                    return Ok(Some(Reached { facets, rounding, is_upright }));
                }
                is_upright
            }
            Counterpart::Itself | Counterpart::Implicit(_) => a.is_upright,
        };
        Ok(Some(Reached { facets, rounding, is_upright }))
    }
}
