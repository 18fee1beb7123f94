//! The highest place between the facets of a simplex and its inner faces.

use super::incentre::incentre;
use crate::geometry::Vector;

/// Part of a weight by which it may differ from another by rounding.
const ROUNDING: f64 = 1e-10;

/// A point in a simplex all of whose corners lie on the surface: on the way from its incentre, away from its facets, as high above them as the
/// middles of its inner faces are.
pub(super) struct Crest {
    /// Weights that are zero but for the corners opposite to facets, in a point that is as high above all of them.
    pub(super) above: [f64; 4],
    /// The same of the inner faces.
    pub(super) below: [f64; 4],
    /// Part of `above` in the crest.
    pub(super) part: f64,
}

impl Crest {
    /// The facets are opposite to the corners that are named by bits, the inner faces to the others. `None` if the incentre lies as high
    /// already, if there is one inner face only, or if the simplex is flat.
    pub(super) fn new<const D: usize>(corners: &[Vector<D>; 4], facets: u8, inner: u8) -> Option<Self> {
        let ((above, height), (below, depth)) = (incentre(corners, facets)?, incentre(corners, inner)?);
        let part = Self::part::<D>(facets);
        // Heights are inverse to sums of areas, and so to parts of the incentre.
        let of_incentre = depth / (height + depth);
        // With one inner face alone it would lie on that, which has its own point.
        (part < 1.0 && of_incentre < part * (1.0 - ROUNDING)).then_some(Self { above, below, part })
    }

    /// Part of `above` in the crest: as much as the middle of an inner face has.
    pub(super) fn part<const D: usize>(facets: u8) -> f64 {
        f64::from(facets.count_ones()) / D as f64
    }

    /// Weights of the corners.
    pub(super) fn weights(&self) -> [f64; 4] {
        std::array::from_fn(|k| self.part * self.above[k] + (1.0 - self.part) * self.below[k])
    }
}
