//! How far the heights of coarse faces are wrong where they meet.
//!
//! The heights of both surfaces are added to the depth as though the facets were parallel. Where their normals differ by the angle φ, the
//! surface of one lies along the normal of the other by cos φ of its height only: the depth is wrong by up to
//!
//! ```text
//! e = (1 − cos φ) max(|s_A|, |s_B|)
//! ```
//!
//! On a circle of radius R, with faces that turn by α, heights grow as α² R and φ as α: e goes with the fourth power of α. Rings of 12 to
//! 64 faces are wrong by up to α⁴ R / 90 where cells are of second order, and by α⁴ R / 100 to 200 where they are smoothed.

use crate::geometry::boundary::sags::SMOOTH;
use crate::overlap::pair::sides::Pair;
use crate::overlap::pair::warning::Warning;
use crate::ranks::packed;

/// Of the mean penetration, the part that an error may have: pressures at single points are wrong by as large a part of their mean. In
/// press fits of 12 to 84 faces, with k = 10 E/h, they are within 30 % below it; at three times it they are wrong by factors, and from ten
/// times on the force is too.
const LARGEST_PART: f64 = 0.4;

/// Of the points of curved faces in contact: integrals over them, and the largest error.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct HeightErrors {
    pub(super) area: f64,
    pub(super) depth: f64,
    pub(super) error: f64,
}

packed!(HeightErrors { area, depth, error });

impl HeightErrors {
    /// Adds a point of a quadrature.
    pub(super) fn add(&mut self, area: f64, depth: f64) {
        self.area += area;
        self.depth += area * depth;
    }

    /// Takes a corner of a part of a facet, where heights are largest: the heights of both surfaces, and 1 − cos φ of the facets.
    pub(super) fn see(&mut self, heights: [f64; 2], turn: f64) {
        // Facets that do not face each other, as beside a wall, are no two sides of one surface.
        if turn < 1.0 - SMOOTH {
            self.error = self.error.max(turn * heights[0].abs().max(heights[1].abs()));
        }
    }

    pub(super) fn add_all(&mut self, other: &Self) {
        self.area += other.area;
        self.depth += other.depth;
        self.error = self.error.max(other.error);
    }

    /// A warning where the largest error is not small against the mean penetration.
    pub(super) fn warning<const D: usize>(&self, pair: &Pair<D>) -> Option<Warning> {
        let [a, b] = pair.partners;
        let told = || Warning::CoarseFaces { a, b, error: self.error, penetration: self.depth / self.area };
        (self.error * self.area > LARGEST_PART * self.depth).then(told)
    }
}
