//! Parts of a facet, halved where too many faces are near.

use crate::geometry::Vector;
use crate::geometry::primitives::convex_piece::place;

/// Linear functions of which the least is looked for on a facet: each is compared with each, so that it is cheaper to halve the
/// facet from some such number on.
const MANY: usize = 16;

/// Near a place that is as far from many faces all of them stay: after so many halvings in a row that leave more than this part of
/// them a part is not halved any more.
const VAIN: u8 = 3;
const LEFT: f64 = 0.8;

/// A simplex in a facet.
pub(super) struct FacetPart<const D: usize> {
    /// Its corners, in the facet's barycentric coordinates.
    weights: [[f64; D]; D],
    /// Its part of the facet's measure.
    pub(super) share: f64,
    /// Number of functions before it was halved, and the halvings in a row that left most of them.
    before: usize,
    vain: u8,
}

impl<const D: usize> FacetPart<D> {
    pub(super) fn whole() -> Self {
        let weights = std::array::from_fn(|a| std::array::from_fn(|b| f64::from(u8::from(a == b))));
        Self { weights, share: 1.0, before: usize::MAX, vain: 0 }
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

    /// Its two halves about the middle of its longest edge, if so many functions are too many; `None` if they are few, or if
    /// halving is in vain.
    pub(super) fn halves(&self, facet: &[Vector<D>; D], count: usize) -> Option<[Self; 2]> {
        let vain = if count as f64 > LEFT * self.before as f64 { self.vain + 1 } else { 0 };
        if count <= MANY || vain >= VAIN {
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
            Self { weights, share: 0.5 * self.share, before: count, vain }
        }))
    }
}
