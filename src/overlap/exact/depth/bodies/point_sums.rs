//! The points of one facet, cell by cell of the other body.

use crate::depth::DepthPiece;
use crate::geometry::Vector;
use crate::overlap::depth_points::{DepthPoint, PlaceInCell};
use crate::overlap::pair::body_facet::BodyFacet;

/// Sums over what a facet has inside the cells of the other body, in parts of its measure.
#[derive(Default)]
pub(crate) struct PointSums<const D: usize>(Vec<InCell<D>>);

/// Sums over what it has inside one cell; of what belongs to the cell, times the depth.
struct InCell<const D: usize> {
    cell: u32,
    area: f64,
    depths: [f64; D],
    slope: Vector<D>,
    weights: [f64; 8],
    gradients: [Vector<D>; 8],
}

impl<const D: usize> PointSums<D> {
    /// Adds what lies inside a piece: its area, ∫ N g dA for the corners of the facet, whose coordinates in the piece are
    /// `barycentric`.
    pub(crate) fn add(&mut self, piece: &DepthPiece<D>, area: f64, depths: &[f64; D], barycentric: &[[f64; 4]; D]) {
        let place = self.0.iter().position(|sums| sums.cell == piece.cell).unwrap_or_else(|| {
            self.0.push(InCell {
                cell: piece.cell,
                area: 0.0,
                depths: [0.0; D],
                slope: Vector::zeros(),
                weights: [0.0; 8],
                gradients: [Vector::zeros(); 8],
            });
            self.0.len() - 1
        });
        let sums = &mut self.0[place];
        let total: f64 = depths.iter().sum();
        sums.area += area;
        sums.depths.iter_mut().zip(depths).for_each(|(sum, depth)| *sum += depth);
        sums.slope += piece.gradient * area;
        let at: [f64; 4] = std::array::from_fn(|k| (0..D).map(|c| depths[c] * barycentric[c][k]).sum());
        sums.weights.iter_mut().zip(piece.at_nodes(&at)).for_each(|(sum, weight)| *sum += weight);
        for (weights, slope) in piece.weights.iter().zip(&piece.slopes).take(D + 1) {
            for (sum, weight) in sums.gradients.iter_mut().zip(weights) {
                *sum += slope * (weight * total);
            }
        }
    }

    /// The points where there is pressure, in the order in which their cells came; the force of the facet counts by
    /// `weight`.
    pub(crate) fn into_points(
        self,
        facet: &BodyFacet<D>,
        (of_b, weight): (bool, f64),
    ) -> impl Iterator<Item = DepthPoint<D>> {
        let (number, measure) = (facet.number, facet.measure);
        self.0.into_iter().filter_map(move |sums| {
            let total: f64 = sums.depths.iter().sum();
            let is_pressed = sums.area > 0.0 && total > 0.0;
            is_pressed.then(|| DepthPoint {
                of_b,
                facet: number,
                weights: sums.depths.map(|depth| depth / total),
                depth: total / sums.area,
                area: weight * measure * sums.area,
                slope: sums.slope * (weight * measure),
                other: Some(PlaceInCell {
                    cell: sums.cell,
                    weights: sums.weights.map(|weight| weight / total),
                    gradients: sums.gradients.map(|gradient| gradient / total),
                }),
            })
        })
    }
}
