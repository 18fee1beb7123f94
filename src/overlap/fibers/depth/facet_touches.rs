//! The crossings of lines with facets, facet by facet.

use super::line_sums::Touch;
use crate::geometry::Vector;
use crate::geometry::Weighting;
use crate::geometry::convex_piece::place;
use crate::overlap::depth::cell_pieces::CellPieces;
use crate::overlap::depth::deep_bodies::{DeepBodies, WEIGHT};
use crate::overlap::depth::facet_blocks::{FacetBlocks, MOST};
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::point_sums::PointSums;
use crate::overlap::depth_integral::SecondDerivative;
use crate::overlap::pair::body_facet::BodyFacet;

/// Cosine of an angle between normals that is rounding.
const SAME_WAY: f64 = 1.0 - 1e-9;

/// The crossings of facets of one side in the pieces of the other.
pub(super) struct FacetTouches<'a, const D: usize> {
    pub(super) bodies: &'a DeepBodies<'a, D>,
    pub(super) other: &'a CellPieces<D>,
    /// Measure of boundary that a crossing stands for, by the facet's normal and the family of the line.
    pub(super) measure: &'a (dyn Fn(&Vector<D>, usize) -> f64 + Sync),
    /// Places nearer than this are one.
    pub(super) tolerance: f64,
}

/// A crossing, and the family of its line.
pub(super) type OfFamily<const D: usize> = (Touch<D>, usize);

impl<const D: usize> FacetTouches<'_, D> {
    /// Of facets, each with all its crossings, piece by piece.
    pub(super) fn sums(&self, facets: &[&[OfFamily<D>]]) -> FacetSums<D> {
        let pair = self.bodies.pair;
        let mut sums = FacetSums::default();
        for touches in facets {
            let [(first, _), ..] = **touches else { continue };
            let side = pair.side(first.of_b);
            let Some(facet) = BodyFacet::new(pair.surface, side, first.facet) else { continue };
            if pair.weighting.is_axis(&facet.corners, self.tolerance) {
                continue;
            }
            let [mut areas, mut depths, mut pressed] = [[0.0; D]; 3];
            let mut points = PointSums::default();
            let before = sums.piece_count;
            for in_piece in touches.chunk_by(|p, q| p.0.piece == q.0.piece) {
                let found = self.add(&facet, in_piece, &mut points, &mut sums);
                for (sum, part) in areas.iter_mut().chain(&mut depths).chain(&mut pressed).zip(found.iter().flatten()) {
                    *sum += part;
                }
            }
            if sums.piece_count > before {
                let side = (first.of_b, WEIGHT);
                sums.add_to_nodes(&facet, &areas, &depths, &pressed, side);
                sums.points.extend(points.into_points(&facet, side));
            }
        }
        sums
    }

    /// Adds the crossings of a facet in one piece; ∫ N_a, ∫ g N_a and ∫ 2 φ(g) N_a over what they stand for, in parts of its
    /// measure.
    fn add(
        &self,
        facet: &BodyFacet<D>,
        touches: &[OfFamily<D>],
        points: &mut PointSums<D>,
        sums: &mut FacetSums<D>,
    ) -> [[f64; D]; 3] {
        let DeepBodies { pair, cells, request, .. } = *self.bodies;
        let weighting: Weighting = pair.weighting;
        let piece = &self.other.pieces[touches[0].0.piece as usize];
        let blocks = FacetBlocks { cells, weight: WEIGHT, weighting, second: request.second };
        let is_same_way = piece.is_at_surface && facet.normal.dot(&piece.gradient) < -SAME_WAY * piece.gradient.norm();
        let ([mut areas, mut depths, mut pressed], mut moved) = ([[0.0; D]; 3], [[0.0; D]; D]);
        let mut products = [[0.0; MOST]; MOST];
        let count = facet.nodes.len() + cells.nodes(piece.cell as usize).len();
        for (touch, family) in touches {
            let g: f64 = (0..=D).map(|k| touch.in_piece[k] * piece.depths[k]).sum();
            let bare = piece.sign * (self.measure)(&facet.normal, *family) / facet.measure;
            let share = bare * weighting.at(&place(&facet.corners, &touch.weights));
            if is_same_way && (g + pair.clearance).abs() <= self.tolerance {
                sums.flush += share * facet.measure;
            }
            if !touch.is_inside || (piece.is_cut() && g <= 0.0) {
                continue;
            }
            sums.piece_count += 1;
            sums.area += share * facet.measure;
            sums.depth += share * facet.measure * g;
            sums.deepest = sums.deepest.max(g);
            for a in 0..D {
                areas[a] += share * touch.weights[a];
                depths[a] += share * g * touch.weights[a];
                pressed[a] += share * (2.0 * request.profile.density(g)) * touch.weights[a];
                (0..D).for_each(|c| moved[a][c] += bare * g * touch.weights[a] * touch.weights[c]);
            }
            if request.second != SecondDerivative::No {
                let share = share * (2.0 * request.profile.slope(g));
                let shapes = blocks.shapes(facet, piece, &touch.weights, &touch.in_piece);
                for (row, a) in products.iter_mut().zip(&shapes[..count]) {
                    row.iter_mut().zip(&shapes[..count]).for_each(|(sum, b)| *sum += share * a * b);
                }
            }
        }
        if request.points {
            let barycentric = facet.corners.each_ref().map(|x| piece.barycentric(x));
            points.add(piece, &areas, &depths, &barycentric);
        }
        if request.second != SecondDerivative::No {
            blocks.add(facet, piece, &products, (&pressed, &moved), &mut Vec::new(), &mut sums.hessian);
        }
        [areas, depths, pressed]
    }
}
