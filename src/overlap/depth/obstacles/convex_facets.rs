//! The depth of a body's facets below the surface of a convex solid: on a piece of a facet it is the depth below one face.

use super::convex_solid::ConvexSolid;
use super::facet_moments::FacetMoments;
use super::facet_part::FacetPart;
use super::least_of::cut_to_least;
use crate::geometry::Weighting;
use crate::geometry::primitives::convex_piece::Piece;
use crate::geometry::primitives::quadrature::for_each_gauss_point;
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::second_derivative::SecondDerivative;

/// What a facet has inside the solid, where the depth is more by `beyond`. All integrands are of degree 2, in the plane 3, which the quadrature takes exactly.
pub(crate) fn facet_moments<const D: usize>(
    solid: &ConvexSolid<D>,
    (facet, weighting): (&BodyFacet<D>, Weighting),
    (beyond, rounding): (f64, f64),
    second: SecondDerivative,
    work: &mut Piece<D>,
) -> FacetMoments<D> {
    let mut moments = FacetMoments::default();
    let slopes_too = second != SecondDerivative::No;
    let mut sums = Sums { solid, facet, weighting, beyond, rounding, slopes_too, moments: &mut moments, work };
    sums.add(&FacetPart::whole());
    moments
}

/// The sums over a facet.
struct Sums<'a, const D: usize> {
    solid: &'a ConvexSolid<'a, D>,
    facet: &'a BodyFacet<D>,
    weighting: Weighting,
    beyond: f64,
    rounding: f64,
    slopes_too: bool,
    moments: &'a mut FacetMoments<D>,
    work: &'a mut Piece<D>,
}

impl<const D: usize> Sums<'_, D> {
    /// Adds a part, in halves where too many faces are near.
    fn add(&mut self, at: &FacetPart<D>) {
        let Self { solid, facet, weighting, beyond, rounding, .. } = *self;
        let near = solid.nearest(&at.corners(&facet.corners));
        if let Some(halves) = at.halves(&facet.corners, near.len()) {
            return halves.iter().for_each(|half| self.add(half));
        }
        let (moments, work) = (&mut *self.moments, &mut *self.work);
        let of_near: Vec<[f64; D]> = near.iter().map(|(_, depths)| *depths).collect();
        for (k, &(face, _)) in near.iter().enumerate() {
            if !cut_to_least(&of_near, k, rounding, work) {
                continue;
            }
            let depth = |w: &[f64; D]| (0..D).map(|c| w[c] * of_near[k][c]).sum::<f64>() + beyond;
            let gradient = -solid.heights[face as usize].slope;
            moments.piece_count += 1;
            work.corners().iter().for_each(|w| moments.reach(depth(w)));
            for_each_gauss_point(work.corners(), false, |w, part| {
                let slopes = self.slopes_too.then_some(&gradient);
                moments.add_point((facet, weighting), &at.in_whole(w), part * at.share, depth(w), slopes);
            });
        }
    }
}
