//! What lies between two facets that face one another.
//!
//! From a point of the first facet a ray leads along its normal to the second: outwards over a gap, inwards through an overlap. Over a gap it
//! must cross no other facet of either body. In an overlap it must not leave the first body and enter the second on the way: one of both
//! alone it may do near a sharp edge. So the outer faces of two thin plates, one on the other, are no pair, however large the reach.
//!
//! Parts of the first facet that are hidden are cut off. No length is compared with anything but the rounding of coordinates.

use super::common_pieces::{Facing, seen_along};
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::{Corners, cut, place, value};
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::quadrature::for_each_simplex;

impl<const D: usize> Facing<'_, D> {
    /// The parts of a piece of the first facet, whose corners and normal these are, from which nothing hides the second, the gap being
    /// linear on it; without parts that are too small to count.
    pub(super) fn visible(
        &self,
        [here, there]: [usize; 2],
        (x, n): (&[Vector<D>; D], &Vector<D>),
        gaps: &[f64; D],
        (piece, least): (&[[f64; D]], f64),
    ) -> Vec<Corners<D>> {
        let mut parts = vec![Corners::from_slice(piece)];
        if piece.iter().all(|w| value(w, gaps).abs() <= self.rounding) {
            return parts;
        }
        let ends = piece.iter().flat_map(|w| [place(x, w), place(x, w) + n * value(w, gaps)]);
        let around = Aabb::of(&ends.collect::<Vec<_>>()).inflated(self.rounding);
        let sides = [here, there].map(|facet| self.near_facets.sides(facet));
        let (mut over_gaps, mut leaving, mut entering) = (Vec::new(), Vec::new(), Vec::new());
        for (facet, side) in self.near_facets.near(&around) {
            if facet == here || facet == there {
                continue;
            }
            let z = self.corners(facet);
            let Some((across, heights)) = seen_along(x, &z, n) else { continue };
            let is_alike = area_vector(&z).dot(n) > 0.0;
            let is_of = sides.map(|of| side & of != 0);
            // Over a gap, facets of the first body that turn as the first facet does may lie beside it, and so may those of the second body at
            // the other end. What else lies at an end hides it: matter begins or ends there.
            let is_beside = [is_alike && is_of[0], !is_alike && is_of[1]];
            let region = |sign: f64, is_beside: [bool; 2]| {
                let [starts, ends] = is_beside.map(|is_beside| if is_beside { self.rounding } else { -self.rounding });
                let mut inside: Vec<[f64; D]> = (0..D).map(|k| across.map(|at| -at[k])).collect();
                inside.push(heights.map(|height| starts - sign * height));
                inside.push(std::array::from_fn(|c| ends + sign * (heights[c] - gaps[c])));
                inside.push(gaps.map(|gap| self.rounding - sign * gap));
                // Most are empty: one of these is positive on the whole facet.
                (!inside.iter().any(|function| function.iter().all(|value| *value >= 0.0))).then_some(inside)
            };
            over_gaps.extend(region(1.0, is_beside));
            // A body that overlaps itself leaves and enters itself at the sides of the overlap, too.
            if is_of[usize::from(is_alike)] && sides[0] & sides[1] == 0 {
                let into = if is_alike { &mut entering } else { &mut leaving };
                into.extend(region(-1.0, [false; 2]));
            }
        }
        let without = |mut parts: Vec<Corners<D>>, regions: &[Vec<[f64; D]>], inside: &mut Vec<Corners<D>>| {
            for region in regions {
                parts = parts.into_iter().flat_map(|part| split(part, region, least, inside)).collect();
            }
            parts
        };
        parts = without(parts, &over_gaps, &mut Vec::new());
        let mut left_the_first = Vec::new();
        parts = without(parts, &leaving, &mut left_the_first);
        parts.extend(without(left_the_first, &entering, &mut Vec::new()));
        parts
    }
}

/// What is left of a convex piece without the part where all of these linear functions are at most 0, which is added to what lies inside;
/// the piece itself where that is not more than the least part of the facet that counts.
fn split<const D: usize>(
    piece: Corners<D>,
    functions: &[[f64; D]],
    least: f64,
    inside: &mut Vec<Corners<D>>,
) -> Vec<Corners<D>> {
    let (mut left, mut rest) = (Vec::new(), piece.clone());
    for function in functions {
        let outside = cut(&rest, &function.map(|value| -value));
        if size(&outside) > least {
            left.push(outside);
        }
        rest = cut(&rest, function);
        if size(&rest) <= least {
            return vec![piece];
        }
    }
    inside.push(rest);
    left
}

/// The part of the facet that a convex piece takes.
fn size<const D: usize>(piece: &[[f64; D]]) -> f64 {
    let mut size = 0.0;
    if piece.len() >= D {
        for_each_simplex(piece, |_, part| size += part);
    }
    size
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::primitives::convex_piece::whole;

    /// Without its middle third an interval is two, without the triangle that its middles span a triangle is three.
    #[test]
    fn what_is_left_is_convex_and_complete() {
        let mut inside = Vec::new();
        let left = split::<2>(whole(), &[[1.0 / 3.0, -2.0 / 3.0], [-2.0 / 3.0, 1.0 / 3.0]], 1e-14, &mut inside);
        assert!(left.len() == 2 && left.iter().all(|part| (size(part) - 1.0 / 3.0).abs() < 1e-15), "{left:?}");
        let mut inside = Vec::new();
        let half = |k: usize| std::array::from_fn(|c| if c == k { 0.5 } else { -0.5 });
        let left = split::<3>(whole(), &[half(0), half(1), half(2)], 1e-14, &mut inside);
        assert!(left.len() == 3 && left.iter().all(|part| (size(part) - 0.25).abs() < 1e-15), "{left:?}");
        assert!(inside.len() == 1 && (size(&inside[0]) - 0.25).abs() < 1e-15, "{inside:?}");
        // What is cut off by rounding alone changes nothing.
        assert_eq!(split::<3>(whole(), &[[-1.0, -1.0, 0.0], [1.0, 1.0, -1e-15]], 1e-14, &mut inside), [whole()]);
    }
}
