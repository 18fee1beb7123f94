//! Parts of a facet, halved where too many faces are near.

use crate::geometry::Vector;
use crate::geometry::convex_piece::place;

/// Linear functions of which the least is looked for on a facet: each is compared with each, so that it is cheaper to halve the
/// facet from some such number on.
pub(super) const MANY: usize = 16;

/// A part is not halved below this share of the facet: near a place that is as far from many faces all of them stay.
const LEAST: f64 = 1.0 / 4096.0;

/// A simplex in a facet.
pub(super) struct FacetPart<const D: usize> {
    /// Its corners, in the facet's barycentric coordinates.
    weights: [[f64; D]; D],
    /// Its part of the facet's measure.
    pub(super) share: f64,
}

impl<const D: usize> FacetPart<D> {
    pub(super) fn whole() -> Self {
        let weights = std::array::from_fn(|a| std::array::from_fn(|b| f64::from(u8::from(a == b))));
        Self { weights, share: 1.0 }
    }

    /// Where its corners are, given those of the facet.
    pub(super) fn corners(&self, facet: &[Vector<D>; D]) -> [Vector<D>; D] {
        if self.share == 1.0 { *facet } else { self.weights.each_ref().map(|w| place(facet, w)) }
    }

    /// A point given in its own coordinates, in those of the facet.
    pub(super) fn in_whole(&self, w: &[f64; D]) -> [f64; D] {
        if self.share == 1.0 {
            return *w;
        }
        std::array::from_fn(|b| (0..D).map(|a| w[a] * self.weights[a][b]).sum())
    }

    /// Its two halves about the middle of its longest edge; `None` if it is small.
    pub(super) fn halves(&self, facet: &[Vector<D>; D]) -> Option<[Self; 2]> {
        if self.share < LEAST {
            return None;
        }
        let corners = self.corners(facet);
        let length = |[p, q]: [usize; 2]| (corners[p] - corners[q]).norm_squared();
        let edges = (0..D).flat_map(|p| (p + 1..D).map(move |q| [p, q]));
        let [p, q] = edges.fold([0, 1], |longest, edge| if length(edge) > length(longest) { edge } else { longest });
        let middle = std::array::from_fn(|b| 0.5 * (self.weights[p][b] + self.weights[q][b]));
        Some([q, p].map(|replaced| {
            let mut weights = self.weights;
            weights[replaced] = middle;
            Self { weights, share: 0.5 * self.share }
        }))
    }
}
