//! How the force of a facet changes as the borders of its parts move along it.

use super::facet_point::HALF;
use super::facet_points::FacetPoints;
use super::of_facet::{Below, OfFacet, on};
use super::parabola::Marks;
use super::point_blocks::PointSlopes;
use super::rules::border_points;
use crate::depth_field::DepthPiece;
use crate::geometry::Vector;
use crate::geometry::primitives::convex_piece::place;
use crate::geometry::primitives::facet_slopes::cross;
use crate::overlap::depth::bodies::FacetPart;

impl<const D: usize> FacetPoints<'_, D> {
    /// Adds to the second derivative what the force changes by as the borders of a part move.
    pub(super) fn add_borders(
        &self,
        of_facet: &mut OfFacet<D>,
        below_it: &Below<D>,
        simplex: &DepthPiece<D>,
        (inside, part): (&FacetPart<D>, f64),
    ) {
        let on_facet = inside.on_facet();
        let place = |w: &[f64; D]| place(&of_facet.facet.corners, w);
        let mut borders = Vec::new();
        for corner in 0..on_facet.len() {
            let face = inside.face(corner) as usize;
            if face > D {
                continue;
            }
            let Some(normal) = (-simplex.slopes[face]).try_normalize(0.0) else { continue };
            let next = inside.after(corner);
            let (w, v) = (on_facet[corner], on_facet[next]);
            // Within the facet, out of the part.
            let (out, ends, length) = if D == 2 {
                let out = place(&w) - place(&v);
                (out, [w, w], 1.0)
            } else {
                let along = place(&v) - place(&w);
                (cross(&along, &of_facet.facet.normal), [w, v], along.norm())
            };
            let Some(out) = out.try_normalize(0.0) else { continue };
            let speed = normal.dot(&out);
            if speed > 0.0 && length > 0.0 {
                borders.push((normal / speed, ends, length));
            }
        }
        for (by, [w, v], length) in borders {
            let cuts =
                if D == 2 { Marks::from_slice(&[0.0, 1.0]) } else { self.cuts(of_facet.sag, below_it, [&w, &v]) };
            for pair in cuts.windows(2) {
                let width = pair[1] - pair[0];
                for (at, share) in border_points::<D>() {
                    let at = pair[0] + at * width;
                    self.add_border_point(of_facet, below_it, &on(&w, &v, at), (by, part * share * width * length));
                }
            }
        }
    }

    fn add_border_point(
        &self,
        of_facet: &mut OfFacet<D>,
        below_it: &Below<D>,
        w: &[f64; D],
        (by, part): (Vector<D>, f64),
    ) {
        let (depth, by_coordinate, at) = self.depth(of_facet.sag, below_it, w);
        let (_, pressure, _) = self.tent.at(depth);
        if pressure <= 0.0 {
            return;
        }
        let piece = below_it.piece;
        let (corners, measure) = &of_facet.before;
        // By the measure now, along which the border moves.
        let before = measure * self.weighting.at(&place(corners, w)) / of_facet.facet.measure;
        let gradient = below_it.gradient(&by_coordinate);
        let point = PointSlopes { piece, heights: below_it.heights, on_facet: w, in_piece: &at, gradient: &gradient };
        let border = by * (HALF * before * pressure * part);
        of_facet.blocks.add(self.cells, &of_facet.facet, &point, (0.0, 0.0), Some(border));
    }
}
