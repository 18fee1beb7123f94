//! Points of two surfaces that face one another, for integrals over what both have in common.

use super::common_pieces::{CommonPiece, Facing};
use super::place::{Weights, of_vertices, weights};
use crate::geometry::primitives::convex_piece::{cut, place, value};
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::quadrature::for_each_simplex;
use crate::geometry::primitives::simplex_rule::{InSimplex, degree_5};
use crate::geometry::{Surface, Vector, Weighting};

/// Facets of two surfaces, by number in the mesh's surface, as they lie.
pub(crate) struct FacingSurfaces<'a, const D: usize> {
    facing: Facing<'a, D>,
    weighting: Weighting,
    /// The least and the largest gap at which they face one another.
    limits: [f64; 2],
    rule: Vec<(InSimplex, f64)>,
}

/// A point of a facet, and the point of another facet above it.
pub(crate) struct FacingPoint<const D: usize> {
    /// Barycentric coordinates in both facets.
    pub(crate) places: [[f64; D]; 2],
    /// For how much area (2D: length) it stands.
    pub(crate) measure: f64,
    /// How far the second point lies above the first, along the normal of the straight facet; negative where they overlap.
    pub(crate) gap: f64,
}

impl<'a, const D: usize> FacingSurfaces<'a, D> {
    pub(crate) fn new(
        surface: &'a Surface<D>,
        vertices: &'a [Vector<D>],
        weighting: Weighting,
        facets: [Vec<usize>; 2],
        limits: [f64; 2],
    ) -> Self {
        let facing = Facing::new(surface, vertices, facets, limits[0].abs().max(limits[1].abs()));
        Self { facing, weighting, limits, rule: degree_5(D - 1) }
    }

    /// Pairs of facets, by number in the surface, that may have a piece in common; ordered. With `is_swapped` those of the second side come
    /// first.
    pub(crate) fn candidates(&self, is_swapped: bool) -> Vec<[usize; 2]> {
        self.facing.candidates(is_swapped)
    }

    /// Calls `visit` for the points at which the first facet faces the second. Pieces end where the gap is `level`: no sum of points runs
    /// across it.
    pub(crate) fn for_each_point(&self, facets: [usize; 2], level: f64, mut visit: impl FnMut(&FacingPoint<D>)) {
        for piece in self.facing.common_within(facets, self.limits) {
            self.add_by_level(&piece, level, &mut visit);
        }
    }

    fn add_by_level(&self, piece: &CommonPiece<D>, level: f64, visit: &mut impl FnMut(&FacingPoint<D>)) {
        let over = |w: &[f64; D]| value(w, &piece.gaps) - level;
        if !(piece.corners.iter().any(|w| over(w) > 0.0) && piece.corners.iter().any(|w| over(w) < 0.0)) {
            return self.add(piece, &piece.corners, visit);
        }
        for sign in [1.0, -1.0] {
            let part = cut(&piece.corners, &piece.gaps.map(|gap| sign * (gap - level)));
            if part.len() >= D {
                self.add(piece, &part, visit);
            }
        }
    }

    fn add(&self, piece: &CommonPiece<D>, part: &[[f64; D]], visit: &mut impl FnMut(&FacingPoint<D>)) {
        let corners = self.facing.corners(piece.facets[0]);
        let size = area_vector(&corners).norm();
        for_each_simplex(part, |simplex, share| {
            for (at, weight) in &self.rule {
                let at: [f64; D] = std::array::from_fn(|c| (0..D).map(|k| at[k] * simplex[k][c]).sum());
                let across = std::array::from_fn(|k| (0..D).map(|c| at[c] * piece.across[c][k]).sum());
                let measure = weight * share * size * self.weighting.at(&place(&corners, &at));
                visit(&FacingPoint { places: [at, across], measure, gap: value(&at, &piece.gaps) });
            }
        });
    }

    /// Values of the shape functions of the points that have any at a place of a facet.
    pub(crate) fn shape(&self, facet: usize, at: &[f64; D]) -> Weights {
        shape_at(self.facing.surface, facet, at)
    }

    /// The same of the straight facet.
    pub(crate) fn straight(&self, facet: usize, at: &[f64; D]) -> Weights {
        of_vertices(self.facing.surface, facet, at)
    }
}

/// Values of the shape functions of the points that have any at a place of a facet.
pub(crate) fn shape_at<const D: usize>(surface: &Surface<D>, facet: usize, at: &[f64; D]) -> Weights {
    weights(surface, facet, at)
}

/// Unit normal of a facet, outwards; zero where it has no area.
pub(crate) fn normal_of<const D: usize>(surface: &Surface<D>, vertices: &[Vector<D>], facet: usize) -> Vector<D> {
    let corners = surface.facets[facet].map(|vertex| vertices[vertex as usize]);
    area_vector(&corners).try_normalize(0.0).unwrap_or_else(Vector::zeros)
}
