//! Moments of what the lines have inside, in the barycentric coordinates of the pieces.

use super::line_sums::{LineSums, Span};
use crate::geometry::Weighting;
use crate::geometry::quadrature::ON_CURVE;
use crate::overlap::depth::cell_integrals::{CellMoments, Products};
use crate::overlap::depth::cell_pieces::CellPieces;
use crate::overlap::depth_integral::DepthProfile;

/// How the spans of one side are summed.
pub(super) struct Moments {
    pub(super) of_b: bool,
    /// Volume for which a unit of length stands.
    pub(super) per_length: f64,
    pub(super) weighting: Weighting,
    pub(super) profile: DepthProfile,
}

impl Moments {
    /// Of every piece of the side.
    pub(super) fn of<const D: usize>(&self, pieces: &CellPieces<D>, sums: &[LineSums<D>]) -> CellMoments {
        let spans = || sums.iter().flat_map(|sum| &sum.spans).filter(|span| span.of_b == self.of_b);
        if !self.weighting.is_plain() {
            let mut products: Vec<Products> = vec![[[0.0; 4]; 4]; pieces.pieces.len()];
            spans().for_each(|span| self.add_products(span, &mut products[span.piece as usize]));
            return CellMoments::weighted(pieces, products, self.weighting);
        }
        let mut first = vec![[0.0; 4]; pieces.pieces.len()];
        for span in spans() {
            let half = 0.5 * self.per_length * span.length;
            for (k, sum) in first[span.piece as usize].iter_mut().enumerate() {
                *sum += half * (span.ends[0][k] + span.ends[1][k]);
            }
        }
        let mut moments = CellMoments::plain(first);
        if self.profile != DepthProfile::Quadratic {
            let (mut value, mut pressed) = (0.0, vec![[0.0; 4]; pieces.pieces.len()]);
            spans().for_each(|span| value += self.add_pressed(span, &mut pressed[span.piece as usize]));
            moments.profile = Some((value, pressed));
        }
        moments
    }

    /// Adds ∫ of the products of two coordinates.
    fn add_products(&self, span: &Span, products: &mut Products) {
        let sixth = self.per_length * span.length / 6.0;
        let [p, q] = &span.ends;
        for (k, row) in products.iter_mut().enumerate() {
            for (l, sum) in row.iter_mut().enumerate() {
                *sum += sixth * (2.0 * p[k] * p[l] + p[k] * q[l] + q[k] * p[l] + 2.0 * q[k] * q[l]);
            }
        }
    }

    /// Adds ∫ 2 φ' of every coordinate; ∫ φ.
    fn add_pressed(&self, span: &Span, pressed: &mut [f64; 4]) -> f64 {
        let mut value = 0.0;
        span.for_each_point(|at, s, part| {
            let measure = self.per_length * part;
            value += measure * self.profile.density(s);
            let slope = measure * 2.0 * self.profile.slope(s);
            pressed.iter_mut().zip(at).for_each(|(sum, at)| *sum += slope * at);
        });
        value
    }
}

impl Span {
    /// Calls `visit(barycentric coordinates, sum of the depths, length)` for the points of a quadrature.
    pub(super) fn for_each_point(&self, mut visit: impl FnMut(&[f64; 4], f64, f64)) {
        for (from_middle, weight) in ON_CURVE {
            let between = |p: f64, q: f64| p + (0.5 + from_middle) * (q - p);
            let at: [f64; 4] = std::array::from_fn(|k| between(self.ends[0][k], self.ends[1][k]));
            visit(&at, between(self.depths[0], self.depths[1]), weight * self.length);
        }
    }
}
