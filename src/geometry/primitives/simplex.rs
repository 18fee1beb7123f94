//! A facet clipped by a simplex.
//!
//! The distance of the facet's corners from a plane of the simplex is computed from the plane's points in an order that
//! depends on their coordinates only, so that two simplices that share a face get the same number with opposite sign
//! and no part of a facet is counted twice or lost between them, whatever the rounding.

use super::aabb::Aabb;
use super::convex_piece::Piece;
use super::orientation::{DOUBTFUL, bound, orientation, precise_orientation, size};
use crate::geometry::Vector;

/// A triangle (2D) or tetrahedron (3D); face k lies opposite to corner k.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Simplex<const D: usize> {
    /// D + 1 corners in the order of their coordinates, and zeros.
    corners: [Vector<D>; 4],
    /// Bit k is set where face k lies on the boundary of the body.
    boundary: u8,
    /// +1 where the corners in this order enclose a positive volume, or −1.
    turn: f64,
    /// +1, or −1 where the simplex is to be subtracted.
    pub(crate) sign: f64,
}

impl<const D: usize> Simplex<D> {
    /// Simplex with these D + 1 corners, `None` if it is flat; bit k of `boundary` belongs to the face opposite to
    /// corner k. It counts negative where its corners enclose a negative volume, and the other way round with
    /// `flipped`.
    pub(crate) fn new(corners: &[Vector<D>], boundary: u8, flipped: bool) -> Option<Self> {
        let mut all = [Vector::zeros(); 4];
        all[..=D].copy_from_slice(&corners[..=D]);
        let (mut boundary, mut flipped) = (boundary, flipped);
        for last in 1..=D {
            for k in (0..last).rev() {
                if !is_after(&all[k], &all[k + 1]) {
                    break;
                }
                all.swap(k, k + 1);
                let differ = (boundary >> k ^ boundary >> (k + 1)) & 1;
                boundary ^= differ << k | differ << (k + 1);
                flipped = !flipped;
            }
        }
        let volume = orientation(&std::array::from_fn(|k| all[k]), &all[D]);
        let turn = volume.signum();
        (volume != 0.0).then_some(Self { corners: all, boundary, turn, sign: if flipped { -turn } else { turn } })
    }

    pub(crate) fn aabb(&self) -> Aabb<D> {
        Aabb::of(&self.corners[..=D])
    }

    /// Calls `visit` with the piece of a facet inside, and how much of it counts; not at all if it is empty. Returns
    /// whether it is empty because the facet lies on the boundary, from outside.
    ///
    /// A facet in an inner face counts half, so that the two simplices there make one whole. Along the boundary of the
    /// body a few roundings count: a facet that faces it is inside from that depth on, so that bodies which touch feel
    /// nothing; one that looks the same way is taken half with the boundary farther out by the tolerance, half with it
    /// farther in. So of two facets that coincide each counts half, and with any noise on their coordinates one has
    /// just what the other has not. A corner of a facet that crosses a face at an angle is on the face if it is that
    /// close to it.
    pub(crate) fn clip(
        &self,
        facet: &[Vector<D>; D],
        area: &Vector<D>,
        tolerance: f64,
        piece: &mut Piece<D>,
        mut visit: impl FnMut(&Piece<D>, f64),
    ) -> bool {
        let mut part = 1.0;
        let mut cuts = [[0.0; D]; 4];
        let mut shifts = [0.0; 4];
        let mut count = 0;
        for k in 0..=D {
            let Heights { outward, mut heights, is_close } = self.heights(k, facet);
            let (rounding, mut shift, mut touches) = (TOUCHING * tolerance * outward.norm(), 0.0, false);
            if !is_close {
                heights = heights.map(|height| if height.abs() <= rounding { 0.0 } else { height });
            } else if self.boundary >> k & 1 == 1 {
                if self.sign * outward.dot(area) > 0.0 {
                    shift = rounding;
                } else {
                    touches = heights.iter().all(|height| height.abs() <= 2.0 * rounding);
                    heights = heights.map(|height| height + self.sign * rounding);
                }
            }
            // The least and the largest: few branches, which are hard to foretell here.
            let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
            for s in heights {
                (least, largest) = (least.min(s), largest.max(s));
            }
            if least >= shift {
                if largest > 0.0 {
                    return touches;
                }
                part = 0.5;
            } else if largest > -shift {
                (cuts[count], shifts[count]) = (heights, shift);
                count += 1;
            }
        }
        let (cuts, shifts) = (&cuts[..count], &shifts[..count]);
        let mut visit_shifted = |by: f64, part: f64| {
            piece.reset();
            let mut shifted = cuts.iter().zip(shifts).map(|(heights, shift)| heights.map(|height| height + by * shift));
            if shifted.all(|heights| piece.cut(&heights)) {
                visit(piece, part);
            }
        };
        if shifts.iter().all(|&shift| shift == 0.0) {
            visit_shifted(0.0, part);
        } else {
            [-1.0, 1.0].into_iter().for_each(|by| visit_shifted(by, 0.5 * part));
        }
        false
    }

    /// Heights of some corners above face k.
    ///
    /// Where all are close to the face, where they cross it follows from digits that rounding has taken: they are
    /// computed anew. Any two simplices at a face do so together.
    fn heights(&self, k: usize, corners: &[Vector<D>; D]) -> Heights<D> {
        let points: [Vector<D>; D] = std::array::from_fn(|p| self.corners[p + usize::from(p >= k)]);
        let e = points[1] - points[0];
        let mut normal = Vector::<D>::zeros();
        if D == 2 {
            normal[0] = -e[1];
            normal[1] = e[0];
        } else {
            let f = points[D - 1] - points[0];
            normal[0] = e[1] * f[2] - e[2] * f[1];
            normal[1] = e[2] * f[0] - e[0] * f[2];
            normal[2] = e[0] * f[1] - e[1] * f[0];
        }
        // Followed by corner k, the points make up the simplex turned by (−1)^(D−k).
        let outward = if (D - k).is_multiple_of(2) { -self.turn } else { self.turn };
        let (mut largest, mut farthest) = (0.0f64, 0.0f64);
        let mut heights = [0.0; D];
        for (height, x) in heights.iter_mut().zip(corners) {
            let from = x - points[0];
            *height = outward * normal.dot(&from);
            largest = largest.max(height.abs());
            farthest = farthest.max(size(&from));
        }
        // Others cross the plane at an angle of more than this, and rounding moves the crossing by 1e5 times itself at
        // most.
        let is_close = largest <= DOUBTFUL * bound(&points, farthest);
        if is_close {
            heights = corners.each_ref().map(|x| outward * precise_orientation(&points, x));
        }
        Heights { outward: normal * outward, heights, is_close }
    }
}

/// A facet's corners above a face of a simplex.
struct Heights<const D: usize> {
    /// Outward normal of the face, of any length.
    outward: Vector<D>,
    /// In units of the normal's length.
    heights: [f64; D],
    /// Whether the facet lies in the face's plane but for a hundred-thousandth of its size.
    is_close: bool,
}

/// Part of the tolerance by which faces that coincide may differ: a few roundings of a coordinate.
const TOUCHING: f64 = 1.0 / 16.0;

/// Whether `x` comes after `y`, by the first coordinate that differs.
fn is_after<const D: usize>(x: &Vector<D>, y: &Vector<D>) -> bool {
    (0..D).find(|&i| x[i] != y[i]).is_some_and(|i| x[i] > y[i])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Part of a facet inside a simplex, with all faces or none on the boundary.
    fn part<const D: usize>(corners: &[Vector<D>], boundary: bool, facet: &[Vector<D>; D], area: &Vector<D>) -> f64 {
        let mut found = 0.0;
        if let Some(simplex) = Simplex::new(corners, if boundary { 15 } else { 0 }, false) {
            let add = |piece: &Piece<D>, part: f64| found += part * piece.moments().iter().sum::<f64>();
            simplex.clip(facet, area, 1e-14, &mut Piece::default(), add);
        }
        found
    }

    #[test]
    fn facet_in_an_inner_face_counts_once() {
        let v = |x, y| Vector::<2>::new(x, y);
        let (facet, area) = ([v(0.3, 0.0), v(0.6, 0.0)], v(0.0, -0.3));
        let (above, below) = ([v(0.0, 0.0), v(1.0, 0.0), v(0.0, 1.0)], [v(0.0, 0.0), v(0.0, -1.0), v(1.0, 0.0)]);
        assert_eq!(part(&above, false, &facet, &area) + part(&below, false, &facet, &area), 1.0);
        // Normal of the facet points down: it lies on the boundary of `above` the same way, and touches `below`.
        assert_eq!((part(&above, true, &facet, &area), part(&below, true, &facet, &area)), (0.5, 0.0));
    }

    /// A triangle through the middle of a tetrahedron, whatever the order of the corners.
    #[test]
    fn order_of_corners_does_not_matter() {
        let v = Vector::<3>::new;
        let corners = [v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0), v(0.0, 1.0, 0.0), v(0.0, 0.0, 1.0)];
        let facet = [v(-1.0, -1.0, 0.5), v(3.0, -1.0, 0.5), v(-1.0, 3.0, 0.5)];
        for order in [[0, 1, 2, 3], [1, 0, 2, 3], [3, 2, 0, 1], [2, 3, 1, 0], [1, 2, 3, 0]] {
            // The section is a triangle with legs 1/2, the facet has legs 4.
            let found = part(&order.map(|k| corners[k]), false, &facet, &v(0.0, 0.0, 8.0));
            assert!((found - 1.0 / 64.0).abs() < 1e-15, "{order:?}: {found}");
        }
    }
}
