//! The points of one facet, cell by cell of the other body.

use crate::depth_field::DepthPiece;
use crate::geometry::Vector;
use crate::overlap::depth::points::{DepthPlace, DepthPoint, PlaceInCell, beyond, no_deeper};
use crate::overlap::pair::body_facet::BodyFacet;

/// Sums over what a facet has inside the cells of the other body, in parts of its measure.
#[derive(Default)]
pub(crate) struct PointSums<const D: usize>(Vec<InCell<D>>);

/// What it has inside one cell.
struct InCell<const D: usize> {
    cell: u32,
    slope: Vector<D>,
    /// The largest depth, and the largest part with a place in it.
    deepest: f64,
    largest: f64,
    inside: DepthPlace<D>,
    /// How far places lie beyond the cell: those over curved faces do, in the layer around it.
    beyond: f64,
    /// Sums with the depth, and with 1, for weight.
    pressed: PlaceSums<D>,
    middle: PlaceSums<D>,
    /// ∫ of the gradients of the shape functions of the cell's nodes.
    gradients: [Vector<D>; 8],
}

/// Sums for a mean place, with some weight.
struct PlaceSums<const D: usize> {
    /// ∫ of the shape functions of the facet's corners, and of the cell's nodes.
    on_facet: [f64; D],
    in_cell: [f64; 8],
}

impl<const D: usize> PointSums<D> {
    /// Adds what lies inside a piece: ∫ N dA and ∫ N g dA for the corners of the facet, whose coordinates in the piece are
    /// `barycentric`; `corners` are those of that part on the facet.
    pub(crate) fn add(
        &mut self,
        piece: &DepthPiece<D>,
        (areas, depths): (&[f64; D], &[f64; D]),
        barycentric: &[[f64; 4]; D],
        corners: &[[f64; D]],
    ) {
        let sums = self.of_cell(piece.cell);
        let area: f64 = areas.iter().sum();
        sums.look_at(piece, area, barycentric, corners);
        sums.slope += piece.gradient * area;
        sums.pressed.add(piece, depths, barycentric);
        sums.middle.add(piece, areas, barycentric);
        for (weights, slope) in piece.weights.iter().zip(&piece.slopes).take(D + 1) {
            for (sum, weight) in sums.gradients.iter_mut().zip(weights) {
                *sum += slope * (weight * area);
            }
        }
    }

    /// Adds a place inside a piece, and its depth: `area` in parts of the facet's measure, and that times the depth; `gradient` is that of
    /// the depth.
    pub(crate) fn add_point(
        &mut self,
        piece: &DepthPiece<D>,
        (area, pressed): (f64, f64),
        (in_piece, on_facet): (&[f64; 4], &[f64; D]),
        gradient: &Vector<D>,
    ) {
        let sums = self.of_cell(piece.cell);
        sums.deepest = sums.deepest.max(pressed / area);
        let in_cell = piece.at_nodes(in_piece);
        sums.beyond = sums.beyond.max(beyond(&in_cell));
        if area > sums.largest {
            let other = Some(PlaceInCell { cell: piece.cell, weights: in_cell });
            (sums.largest, sums.inside) = (area, DepthPlace { weights: *on_facet, other });
        }
        sums.slope += gradient * area;
        sums.pressed.add_place(pressed, on_facet, &in_cell);
        sums.middle.add_place(area, on_facet, &in_cell);
        for (weights, slope) in piece.weights.iter().zip(&piece.slopes).take(D + 1) {
            for (sum, weight) in sums.gradients.iter_mut().zip(weights) {
                *sum += slope * (weight * area);
            }
        }
    }

    fn of_cell(&mut self, cell: u32) -> &mut InCell<D> {
        let place = self.0.iter().position(|sums| sums.cell == cell).unwrap_or_else(|| {
            self.0.push(InCell::new(cell));
            self.0.len() - 1
        });
        &mut self.0[place]
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
            let (depth, area) = (sums.pressed.total(), sums.middle.total());
            let is_pressed = area > 0.0 && depth > 0.0;
            is_pressed.then(|| {
                let middle = sums.middle.mean(sums.cell).or(sums.inside, sums.beyond);
                DepthPoint {
                    of_b,
                    facet: number,
                    pressed: sums.pressed.mean(sums.cell).or(middle, sums.beyond),
                    middle,
                    gradients: sums.gradients.map(|sum| sum / area),
                    depth: no_deeper(depth / area, sums.deepest),
                    area: weight * measure * area,
                    slope: sums.slope * (weight * measure),
                }
            })
        })
    }
}

impl<const D: usize> InCell<D> {
    fn new(cell: u32) -> Self {
        let [pressed, middle] = [PlaceSums::new(), PlaceSums::new()];
        let other = PlaceInCell { cell, weights: [0.0; 8] };
        let inside = DepthPlace { weights: [0.0; D], other: Some(other) };
        let (slope, gradients) = (Vector::zeros(), [Vector::zeros(); 8]);
        Self { cell, slope, deepest: 0.0, largest: f64::NEG_INFINITY, inside, beyond: 0.0, pressed, middle, gradients }
    }

    /// Takes note of how deep a part lies, and where, if it is the largest so far. Where walls are flush, sums are rounding, and so would
    /// be every mean place that is found from them.
    fn look_at(&mut self, piece: &DepthPiece<D>, area: f64, barycentric: &[[f64; 4]; D], corners: &[[f64; D]]) {
        let at = |w: &[f64; D]| -> [f64; 4] { std::array::from_fn(|k| (0..D).map(|c| w[c] * barycentric[c][k]).sum()) };
        let depth = |w: &[f64; D]| -> f64 { at(w).iter().zip(&piece.depths).take(D + 1).map(|(a, g)| a * g).sum() };
        self.deepest = corners.iter().map(depth).fold(self.deepest, f64::max);
        if area.abs() <= self.largest || corners.is_empty() {
            return;
        }
        let weights: [f64; D] =
            std::array::from_fn(|c| corners.iter().map(|w| w[c]).sum::<f64>() / corners.len() as f64);
        let in_cell = PlaceInCell { cell: self.cell, weights: piece.at_nodes(&at(&weights)) };
        (self.largest, self.inside) = (area.abs(), DepthPlace { weights, other: Some(in_cell) });
    }
}

impl<const D: usize> PlaceSums<D> {
    fn new() -> Self {
        Self { on_facet: [0.0; D], in_cell: [0.0; 8] }
    }

    fn add(&mut self, piece: &DepthPiece<D>, on_facet: &[f64; D], barycentric: &[[f64; 4]; D]) {
        self.on_facet.iter_mut().zip(on_facet).for_each(|(sum, part)| *sum += part);
        let at: [f64; 4] = std::array::from_fn(|k| (0..D).map(|c| on_facet[c] * barycentric[c][k]).sum());
        self.in_cell.iter_mut().zip(piece.at_nodes(&at)).for_each(|(sum, part)| *sum += part);
    }

    fn add_place(&mut self, weight: f64, on_facet: &[f64; D], in_cell: &[f64; 8]) {
        self.on_facet.iter_mut().zip(on_facet).for_each(|(sum, part)| *sum += weight * part);
        self.in_cell.iter_mut().zip(in_cell).for_each(|(sum, part)| *sum += weight * part);
    }

    fn total(&self) -> f64 {
        self.on_facet.iter().sum()
    }

    fn mean(&self, cell: u32) -> DepthPlace<D> {
        let total = self.total();
        let in_cell = PlaceInCell { cell, weights: self.in_cell.map(|sum| sum / total) };
        DepthPlace { weights: self.on_facet.map(|sum| sum / total), other: Some(in_cell) }
    }
}
