//! Points of a common piece, and what lies opposite to them.

use super::common_pieces::{CommonPiece, Facing};
use super::place::{Weights, of_vertices, position, weights};
use crate::geometry::primitives::convex_piece::place;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::facet_slopes::slopes;
use crate::geometry::primitives::quadrature::for_each_simplex;
use crate::geometry::primitives::simplex_rule::degree_5;
use crate::geometry::{Vector, Weighting};

/// Rounds in which the place opposite to a point is found on a curve, and the part of a facet that is near enough.
const ROUNDS: usize = 12;
const NEAR: f64 = 1e-14;

/// A gap that is rounding, by the largest coordinate.
const CLOSED: f64 = 64.0 * f64::EPSILON;

/// A point of quadrature of a piece, and the place opposite to it.
pub(super) struct Opposite<const D: usize> {
    /// Barycentric coordinates in the first facet.
    pub(super) at: [f64; D],
    /// Where it is on the straight facet.
    pub(super) straight: Vector<D>,
    /// What it stands for, in area (2D: length; with axisymmetry that of whole rings).
    pub(super) measure: f64,
    /// What moves the point, and the place opposite to it.
    pub(super) own: Weights,
    pub(super) other: Weights,
    /// How far the point is above that place, along the normal of the second facet.
    pub(super) gap: f64,
}

impl<const D: usize> Facing<'_, D> {
    /// Visits the points of a piece, by a rule of degree 5.
    pub(super) fn for_each_opposite(
        &self,
        points: &[[f64; D]],
        weighting: Weighting,
        piece: &CommonPiece<D>,
        mut visit: impl FnMut(Opposite<D>),
    ) {
        if piece.corners.is_empty() {
            return;
        }
        let [here, there] = piece.facets;
        let corners = self.corners(here);
        let size = area_vector(&corners).norm();
        let rule = degree_5(D - 1);
        for_each_simplex(&piece.corners, |simplex, share| {
            for (at, weight) in &rule {
                let at: [f64; D] = std::array::from_fn(|c| (0..D).map(|k| at[k] * simplex[k][c]).sum());
                let straight = place(&corners, &at);
                let measure = weight * share * size * weighting.at(&straight);
                let own = weights(self.surface, here, &at);
                let start = std::array::from_fn(|k| (0..D).map(|c| at[c] * piece.across[c][k]).sum());
                let from = position(&own, points) + self.shift(here) - self.shift(there);
                let (other, gap) = self.opposite(points, there, from, start);
                visit(Opposite { at, straight, measure, own, other, gap });
            }
        });
    }

    /// The place of a facet that a point is above, as seen from the facet where it was before it is brought, and how far above it the point
    /// is, along the normal of the straight facet.
    fn opposite(&self, points: &[[f64; D]], facet: usize, x: Vector<D>, start: [f64; D]) -> (Weights, f64) {
        let corners = self.corners(facet);
        let area = area_vector(&corners);
        let n = area.normalize();
        let size = area.norm().powf(1.0 / (D as f64 - 1.0));
        let Some((_, gradients)) = slopes(&corners, &n) else { return (Weights::new(), 0.0) };
        let mut at = start;
        let mut found = weights(self.surface, facet, &at);
        for _ in 0..ROUNDS {
            let off = x - position(&found, points);
            let aside = off - n * off.dot(&n);
            if aside.norm() <= NEAR * size {
                break;
            }
            at.iter_mut().zip(&gradients).for_each(|(at, gradient)| *at += gradient.dot(&aside));
            found = weights(self.surface, facet, &at);
        }
        // What is left aside of the normal goes with the facet, too.
        let off = x - position(&found, points);
        let aside = off - n * off.dot(&n);
        let rest = gradients.map(|gradient| gradient.dot(&aside));
        found.extend(of_vertices(self.surface, facet, &rest));
        let rounding = CLOSED * x.amax().max(size);
        let gap = off.dot(&n);
        (found, if gap.abs() > rounding { gap } else { 0.0 })
    }
}
