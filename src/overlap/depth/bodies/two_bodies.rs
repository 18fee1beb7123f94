//! The depth of two bodies below each other's surfaces, summed over their overlap.

use super::cell_integrals::{CellMoments, Products};
use super::cell_pieces::CellPieces;
use super::deep_bodies::{CHUNK, DeepBodies, WEIGHT};
use super::facet_integrals::{FacetsFound, FacetsInCells};
use super::inside_moments::Enclosed;
use super::piece_moments::Moments;
use crate::Error;
use crate::configuration::FacetSide;
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::integral::{DepthIntegral, DepthRequest};
use crate::overlap::pair::bounds::Bounds;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::region::Region;
use crate::overlap::pair::sides::{Counterpart, Pair};

/// J of two bodies, or of one with itself; `None` where the sides are apart.
///
/// # Errors
/// Those of [`DeepBodies::new`].
pub(crate) fn of_bodies<const D: usize>(
    pair: &Pair<D>,
    request: &DepthRequest,
) -> Result<Option<DepthIntegral<D>>, Error> {
    let bodies = DeepBodies::new(pair, request)?;
    Ok(match &pair.counterpart {
        Counterpart::Facets(b) => pair.region()?.and_then(|region| bodies.two(b, region)),
        _ => bodies.one(),
    })
}

impl<const D: usize> DeepBodies<'_, D> {
    /// Of two bodies.
    pub(crate) fn two(&self, b: &FacetSide<D>, region: &Region<D>) -> Option<DepthIntegral<D>> {
        let pair = self.pair;
        let bounds = pair.bounds(region);
        let (of_a, of_b) = pair.both(|| self.pieces(0, region, Some(bounds)), || self.pieces(1, region, Some(bounds)));
        let sides = [&pair.a, b];
        let (facets, moments) = match pair.weighting.is_plain() {
            true => {
                let (facets, moments) = self.inside_each_other(sides, [&of_a, &of_b], region);
                (facets, moments.map(CellMoments::plain))
            }
            false => {
                let (facets, [in_a, in_b]) = self.inside_each_other::<Products>(sides, [&of_a, &of_b], region);
                let weighted = |pieces, products| CellMoments::weighted(pieces, products, pair.weighting);
                (facets, [weighted(&of_a, in_a), weighted(&of_b, in_b)])
            }
        };
        self.assemble(facets, &[(&of_a, &moments[0]), (&of_b, &moments[1])])
    }

    /// What the facets of either body have inside the other, and the moments of the overlap in the pieces of either.
    pub(super) fn inside_each_other<M: Moments>(
        &self,
        sides: [&FacetSide<D>; 2],
        [of_a, of_b]: [&CellPieces<D>; 2],
        region: &Region<D>,
    ) -> (Vec<FacetSums<D>>, [Vec<M>; 2]) {
        let (pair, bounds, rounding) = (self.pair, self.pair.bounds(region), region.aabb.rounding());
        let (in_b, in_a) = pair.both(
            || self.facets(sides[0], (&region.facets[0], bounds), (false, false), of_b, rounding),
            || self.facets(sides[1], (&region.facets[1], bounds), (true, false), of_a, rounding),
        );
        let enclosed = |pieces, side, other| Enclosed { bodies: self, pieces, side, other, bounds, is_own: false };
        let ([facets_a, facets_b], [in_b, in_a]) = ([in_b.0, in_a.0], [in_b.1, in_a.1]);
        let (moments_a, moments_b) = pair.both(
            || enclosed(of_a, sides[1], of_b).moments(in_a.0.into_iter().flatten(), &in_a.1),
            || enclosed(of_b, sides[0], of_a).moments(in_b.0.into_iter().flatten(), &in_b.1),
        );
        (vec![facets_a, facets_b], [moments_a, moments_b])
    }

    /// Of a body with itself: every two of its cells that overlap.
    fn one(&self) -> Option<DepthIntegral<D>> {
        let a = &self.pair.a;
        let region = Region::new(a.aabb, [(0..a.facets.len() as u32).collect(), Vec::new()]);
        let all = self.pieces(0, &region, None);
        let weighting = self.pair.weighting;
        let (facets, moments) = match weighting.is_plain() {
            true => {
                let (facets, moments) = self.inside_itself(&all, &region);
                (facets, CellMoments::plain(moments))
            }
            false => {
                let (facets, products) = self.inside_itself(&all, &region);
                (facets, CellMoments::weighted(&all, products, weighting))
            }
        };
        self.assemble(vec![facets], &[(&all, &moments)])
    }

    pub(super) fn inside_itself<M: Moments>(&self, all: &CellPieces<D>, region: &Region<D>) -> (FacetSums<D>, Vec<M>) {
        let (a, bounds) = (&self.pair.a, self.pair.bounds(region));
        let (sums, (shares, doubtful)) =
            self.facets(a, (&region.facets[0], bounds), (false, true), all, a.aabb.rounding());
        let enclosed = Enclosed { bodies: self, pieces: all, side: a, other: all, bounds, is_own: true };
        (sums, enclosed.moments(shares.into_iter().flatten(), &doubtful))
    }

    pub(super) fn facets<M: Moments>(
        &self,
        side: &FacetSide<D>,
        (facets, bounds): (&[u32], &Bounds<D>),
        (of_b, own): (bool, bool),
        other: &CellPieces<D>,
        rounding: f64,
    ) -> (FacetSums<D>, OfPieces<M>) {
        let (surface, cells, request) = (self.pair.surface, self.cells, self.request);
        let body = if let Partner::Body(body) = self.pair.partners[0] { body } else { 0 };
        let own_cell = own.then(|| &surface.facet_cell[surface.ranges[body].clone()]);
        let weighting = self.pair.weighting;
        let (weight, clearance) = (WEIGHT, self.clearance);
        let of_side = FacetsInCells {
            surface,
            cells,
            side,
            of_b,
            other,
            weight,
            clearance,
            weighting,
            request,
            own_cell,
            bounds,
        };
        let found = self.pair.in_chunks(facets, CHUNK, |facets| of_side.integrals(facets, rounding));
        let (mut sums, mut of_pieces) = (Vec::with_capacity(found.len()), (Vec::new(), Vec::new()));
        for FacetsFound { sums: of_facets, shares, doubtful } in found {
            sums.push(of_facets);
            of_pieces.0.push(shares);
            of_pieces.1.push(doubtful);
        }
        (FacetSums::of_parts(sums), of_pieces)
    }
}

/// What facets add to the moments of pieces, and the pieces of which that is not certain; list by list.
pub(super) type OfPieces<M> = (Vec<Vec<(u32, M)>>, Vec<Vec<u32>>);
