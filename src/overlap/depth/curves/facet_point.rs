//! A point of a facet: its depth, and what it adds.

use super::facet_points::{FacetPoints, PointsFound};
use super::of_facet::{Below, OfFacet};
use super::point_blocks::PointSlopes;
use crate::geometry::Vector;
use crate::geometry::boundary::facet_sags::FacetSag;
use crate::geometry::primitives::convex_piece::place;
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::simplex_parts::{Corners, between};
use crate::overlap::pair::second_derivative::SecondDerivative;

/// Part with which either side counts.
pub(super) const HALF: f64 = 0.5;

impl<const D: usize> FacetPoints<'_, D> {
    /// Depth of a place of the facet below the other surface, and its derivatives by the coordinates in the piece.
    pub(super) fn depth(&self, sag: &FacetSag<D>, below_it: &Below<D>, w: &[f64; D]) -> (f64, [f64; 4], [f64; 4]) {
        let at = below_it.at(w);
        let (height, mut slopes) = below_it.heights.at(&at);
        let mut depth = height + sag.at(w);
        for k in 0..=D {
            depth += at[k] * below_it.piece.depths[k];
            slopes[k] += below_it.piece.depths[k];
        }
        (depth, slopes, at)
    }

    pub(super) fn is_flat(&self, sag: &FacetSag<D>, below_it: &Below<D>) -> bool {
        sag.is_flat() && below_it.heights.is_zero()
    }

    /// Adds the points of a quadrature on a simplex of the facet.
    pub(super) fn add_points(
        &self,
        of_facet: &mut OfFacet<D>,
        below_it: &Below<D>,
        corners: &Corners,
        share: f64,
        found: &mut PointsFound<D>,
    ) {
        for &(at, part) in if self.is_flat(of_facet.sag, below_it) { &self.rules.flat } else { &self.rules.curved } {
            let in_facet = between(corners, &at);
            let w: [f64; D] = std::array::from_fn(|c| in_facet[c]);
            self.add_point(of_facet, below_it, &w, share * part, found);
        }
    }

    pub(super) fn add_point(
        &self,
        of_facet: &mut OfFacet<D>,
        below_it: &Below<D>,
        w: &[f64; D],
        part: f64,
        found: &mut PointsFound<D>,
    ) {
        let (depth, by_coordinate, at) = self.depth(of_facet.sag, below_it, w);
        if depth <= 0.0 {
            return;
        }
        let piece = below_it.piece;
        let weight_at = |corners: &[Vector<D>; D]| self.weighting.at(&place(corners, w));
        let (corners, measure) = &of_facet.before;
        let before = part * measure * weight_at(corners);
        let now = part * weight_at(&of_facet.facet.corners);
        if !self.is_flat(of_facet.sag, below_it) {
            found.errors.add(now * of_facet.facet.measure, depth);
        }
        let (energy, pressure, slope) = self.tent.at(depth);
        found.energy += HALF * before * energy;
        found.volume += HALF * now * of_facet.facet.measure * depth.min(self.tent.top);
        of_facet.is_met = true;
        let sums = &mut found.sums;
        sums.piece_count += 1;
        sums.deepest = sums.deepest.max(depth);
        // In parts of the measure now, so that force by area is the pressure.
        let pressed = before * depth / of_facet.facet.measure;
        for c in 0..D {
            of_facet.area[c] += now * w[c];
            of_facet.depth[c] += pressed * w[c];
        }
        sums.area += now * of_facet.facet.measure;
        sums.depth += pressed * of_facet.facet.measure;
        let gradient = below_it.gradient(&by_coordinate);
        let force = gradient * (HALF * before * pressure);
        if pressure != 0.0 {
            for c in 0..D {
                of_facet.forces[c] += force * w[c];
            }
            let nodes = self.cells.nodes(piece.cell as usize);
            for (&node, weight) in nodes.iter().zip(piece.at_nodes(&at)) {
                sums.gradient.add(node, !self.of_b, &(force * -weight));
            }
        }
        if self.request.points {
            of_facet.points.add_point(piece, (now, pressed), (&at, w), &gradient);
        }
        let (f, q) = match self.request.second {
            SecondDerivative::No => return,
            SecondDerivative::Semidefinite => (0.0, HALF * before),
            SecondDerivative::Full => (HALF * before * pressure, HALF * before * slope),
        };
        let point = PointSlopes { piece, heights: below_it.heights, on_facet: w, in_piece: &at, gradient: &gradient };
        of_facet.blocks.add(self.cells, &of_facet.facet, &point, (f, q), None);
    }

    /// Adds what a facet has to the nodes that move it.
    pub(super) fn finish(&self, mut of_facet: OfFacet<D>, sums: &mut FacetSums<D>) {
        if !of_facet.is_met {
            return;
        }
        let facet = &of_facet.facet;
        sums.add_facet(facet, &of_facet.area, &of_facet.depth, self.of_b);
        for (force, weights) in of_facet.forces.iter().zip(&facet.weights) {
            for (&node, &weight) in facet.nodes.iter().zip(weights).filter(|(_, weight)| **weight != 0.0) {
                sums.gradient.add(node, self.of_b, &(force * weight));
            }
        }
        sums.points.extend(of_facet.points.into_points(facet, (self.of_b, HALF)));
        of_facet.blocks.add_to(&mut sums.hessian);
    }
}
