//! Whether the line between two facets is inside both sides.

use super::projected_facets::{ProjectedFacet, Projection, flat};
use super::projected_pair::ProjectedPair;
use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::plane::Plane;
use crate::overlap::pair::sides::Counterpart;

impl<const D: usize> ProjectedPair<'_, D> {
    /// Whether a line is inside both sides between two facets with nothing between, through one of which it enters and
    /// through the other of which it leaves. Where they are of two sides it is, unless one is inside out there; where they
    /// are of one, the other has to cover the line as well (or the body itself once more).
    pub(crate) fn is_inside_both(
        &self,
        seen: &Projection<D>,
        e: &ProjectedFacet<D>,
        x: &ProjectedFacet<D>,
        place: &[f64; 3],
    ) -> bool {
        let is_one_side = e.of_b == x.of_b;
        if !is_one_side && !self.may_be_inside_out(seen, [e, x], place) {
            return true;
        }
        let [p, q] = [e, x].map(|s| {
            let w = s.barycentric(place);
            let corners = self.pair.side(s.of_b).corners(s.facet as usize);
            (0..D).fold(Vector::zeros(), |sum, a| sum + corners[a] * w[a])
        });
        let middle = (p + q) * 0.5;
        let covering = |side: &FacetSide<D>| side.winding_number(&middle);
        match &self.pair.counterpart {
            Counterpart::Itself => covering(&self.pair.a) > 1,
            Counterpart::Facets(_) if is_one_side => covering(self.pair.side(!e.of_b)) > 0,
            Counterpart::Facets(other) => covering(&self.pair.a) > 0 && covering(other) > 0,
            Counterpart::Implicit(side) => Plane::of(side.pose).height(&middle) < 0.0,
        }
    }

    /// Whether a line that has just passed through one of two facets, away from the other, passes through one of the same
    /// body the other way farther on, or within rounding: between the two it may be as often inside as minus once.
    fn may_be_inside_out(&self, seen: &Projection<D>, ends: [&ProjectedFacet<D>; 2], place: &[f64; 3]) -> bool {
        if seen.is_upright {
            return false;
        }
        let near = seen.near(&Aabb::of(&[flat::<D>(place)]));
        ends.into_iter().any(|facet| {
            let t = facet.t(&facet.barycentric(place));
            let rounding = self.pair.side(facet.of_b).aabb.rounding();
            near.iter().map(|&other| &seen.facets[other as usize]).any(|other| {
                if other.of_b != facet.of_b || other.leaves == facet.leaves {
                    return false;
                }
                let w = other.barycentric(place);
                let ahead = if facet.leaves { other.t(&w) - t } else { t - other.t(&w) };
                ahead >= -rounding && w.iter().all(|w| *w >= 0.0)
            })
        })
    }
}
