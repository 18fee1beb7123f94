//! The depth of two bodies below each other's surfaces, summed over their overlap.

use super::cell_integrals::{CellMoments, Products};
use super::cell_pieces::CellPieces;
use super::deep_bodies::DeepBodies;
use super::deep_bodies::WEIGHT;
use super::facet_integrals::FacetsInCells;
use super::piece_moments::{Moments, common_moments};
use crate::Error;
use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::integral::{DepthIntegral, DepthRequest};
use crate::overlap::pair::bounds::Bounds;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::region::Region;
use crate::overlap::pair::sides::{Counterpart, Pair};

/// Facets, or pieces, that a thread takes at once.
const CHUNK: usize = 64;

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
    fn two(&self, b: &FacetSide<D>, region: &Region<D>) -> Option<DepthIntegral<D>> {
        let pair = self.pair;
        let bounds = pair.bounds(region);
        let (of_a, of_b) = pair.both(|| self.pieces(0, region, Some(bounds)), || self.pieces(1, region, Some(bounds)));
        let rounding = region.aabb.rounding();
        let (facets_a, facets_b) = pair.both(
            || self.facets(&pair.a, (&region.facets[0], bounds), (false, false), &of_b, rounding),
            || self.facets(b, (&region.facets[1], bounds), (true, false), &of_a, rounding),
        );
        let weighting = pair.weighting;
        let [moments_a, moments_b] = if weighting.is_plain() {
            let (of_a, of_b) = self.moments(&of_a, &of_b);
            [of_a, of_b].map(CellMoments::plain)
        } else {
            let (in_a, in_b) = self.moments::<Products>(&of_a, &of_b);
            [(&of_a, in_a), (&of_b, in_b)].map(|(pieces, products)| CellMoments::weighted(pieces, products, weighting))
        };
        self.assemble(vec![facets_a, facets_b], &[(&of_a, &moments_a), (&of_b, &moments_b)])
    }

    /// Moments of the overlap in the barycentric coordinates of every piece of either body.
    fn moments<M: Moments>(&self, of_a: &CellPieces<D>, of_b: &CellPieces<D>) -> (Vec<M>, Vec<M>) {
        let numbered: Vec<usize> = (0..of_a.pieces.len()).collect();
        let found = self.pair.in_chunks(&numbered, CHUNK, |numbers| {
            let mut found = Vec::new();
            for &i in numbers {
                let (piece, aabb) = (&of_a.pieces[i], &of_a.boxes[i]);
                of_b.tree.visit(
                    |node| node.meets(aabb),
                    |j| {
                        let j = j as usize;
                        if of_b.boxes[j].meets(aabb) {
                            found.extend(common_moments(piece, &of_b.pieces[j]).map(|moments| (i, j, moments)));
                        }
                    },
                );
            }
            found
        });
        let (mut in_a, mut in_b) = (vec![M::default(); of_a.pieces.len()], vec![M::default(); of_b.pieces.len()]);
        for (i, j, [of_i, of_j]) in found.into_iter().flatten() {
            in_a[i].add(&of_i);
            in_b[j].add(&of_j);
        }
        (in_a, in_b)
    }

    /// Of a body with itself: every two of its cells that overlap.
    fn one(&self) -> Option<DepthIntegral<D>> {
        let a = &self.pair.a;
        let region = Region::new(a.aabb, [(0..a.facets.len() as u32).collect(), Vec::new()]);
        let bounds = self.pair.bounds(&region);
        let all = self.pieces(0, &region, None);
        let facets = self.facets(a, (&region.facets[0], bounds), (false, true), &all, a.aabb.rounding());
        let weighting = self.pair.weighting;
        let moments = match weighting.is_plain() {
            true => CellMoments::plain(own_moments(&all)),
            false => CellMoments::weighted(&all, own_moments(&all), weighting),
        };
        self.assemble(vec![facets], &[(&all, &moments)])
    }

    fn facets(
        &self,
        side: &FacetSide<D>,
        (facets, bounds): (&[u32], &Bounds<D>),
        (of_b, own): (bool, bool),
        other: &CellPieces<D>,
        rounding: f64,
    ) -> FacetSums<D> {
        let (surface, cells, request) = (self.pair.surface, self.cells, self.request);
        let body = if let Partner::Body(body) = self.pair.partners[0] { body } else { 0 };
        let own_cell = own.then(|| &surface.facet_cell[surface.ranges[body].clone()]);
        let weighting = self.pair.weighting;
        let (weight, clearance) = (WEIGHT, self.pair.clearance);
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
        let parts = self.pair.in_chunks(facets, CHUNK, |facets| of_side.integrals(facets, rounding));
        FacetSums::of_parts(parts)
    }
}

/// The same of every two cells of a body that overlap.
fn own_moments<M: Moments, const D: usize>(all: &CellPieces<D>) -> Vec<M> {
    let mut moments = vec![M::default(); all.pieces.len()];
    let may_meet = |i: u32, aabb: &Aabb<D>| all.boxes[i as usize].meets(aabb);
    all.tree.visit_own_pairs(&Vector::zeros(), may_meet, |i, j| {
        let (p, q) = (&all.pieces[i as usize], &all.pieces[j as usize]);
        if p.cell != q.cell
            && all.boxes[i as usize].meets(&all.boxes[j as usize])
            && let Some([in_p, in_q]) = common_moments::<M, D>(p, q)
        {
            moments[i as usize].add(&in_p);
            moments[j as usize].add(&in_q);
        }
        true
    });
    moments
}
