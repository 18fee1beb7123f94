//! A facet clipped by a simplex.
//!
//! The distance of the facet's corners from a plane of the simplex is computed from the plane's points in an order that
//! depends on their coordinates only, so that two simplices that share a face get the same number with opposite sign
//! and no part of a facet is counted twice or lost between them, whatever the rounding.

use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::convex_piece::Piece;
use crate::geometry::facet::determinant;

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
        let volume = determinant::<D>(&std::array::from_fn(|k| all[k + 1] - all[0]));
        let turn = volume.signum();
        (volume != 0.0).then_some(Self { corners: all, boundary, turn, sign: if flipped { -turn } else { turn } })
    }

    pub(crate) fn aabb(&self) -> Aabb<D> {
        Aabb::of(&self.corners[..=D])
    }

    /// Cuts the piece of a facet inside out of it, and returns how much of it counts; `None` if it is empty.
    ///
    /// Distances up to the tolerance are rounding and count as zero. A facet that lies in a face of the simplex counts
    /// half, so that the two simplices at an inner face make one whole, and identical bodies share; but it counts
    /// nothing where it lies on the outside of a body's boundary: the bodies touch there.
    pub(crate) fn clip(
        &self,
        facet: &[Vector<D>; D],
        area: &Vector<D>,
        tolerance: f64,
        piece: &mut Piece<D>,
    ) -> Option<f64> {
        let mut part = 1.0;
        let mut cuts = [[0.0; D]; 4];
        let mut cut_count = 0;
        for k in 0..=D {
            let (outward, point) = self.plane(k);
            let tolerance = tolerance * outward.norm();
            // Distances in units of the normal's length, the least and the largest: few branches, which are hard to
            // foretell here.
            let (mut distance, mut least, mut largest) = ([0.0; D], f64::INFINITY, f64::NEG_INFINITY);
            for (s, x) in distance.iter_mut().zip(facet) {
                let exact = outward.dot(&(x - point));
                *s = if exact.abs() <= tolerance { 0.0 } else { exact };
                (least, largest) = (least.min(*s), largest.max(*s));
            }
            if least >= 0.0 {
                let same_way = outward.dot(area) > 0.0;
                if largest > 0.0 || self.boundary >> k & 1 == 1 && !same_way {
                    return None;
                }
                part = 0.5;
            } else if largest > 0.0 {
                cuts[cut_count] = distance;
                cut_count += 1;
            }
        }
        piece.reset();
        cuts[..cut_count].iter().all(|distance| piece.cut(distance)).then_some(part)
    }

    /// Outward normal of face k, of any length, and a point of the face.
    ///
    /// Followed by corner k, its points make up the simplex turned by (−1)^(D−k).
    fn plane(&self, k: usize) -> (Vector<D>, Vector<D>) {
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
        (normal * if (D - k).is_multiple_of(2) { -self.turn } else { self.turn }, points[0])
    }
}

/// Whether `x` comes after `y`, by the first coordinate that differs.
fn is_after<const D: usize>(x: &Vector<D>, y: &Vector<D>) -> bool {
    (0..D).find(|&i| x[i] != y[i]).is_some_and(|i| x[i] > y[i])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Part of a facet inside a simplex with all faces on the boundary, or none.
    fn part<const D: usize>(corners: &[Vector<D>], boundary: bool, facet: &[Vector<D>; D], area: &Vector<D>) -> f64 {
        let mut piece = Piece::default();
        let simplex = Simplex::new(corners, if boundary { 15 } else { 0 }, false);
        let part = simplex.and_then(|s| s.clip(facet, area, 0.0, &mut piece));
        part.map_or(0.0, |part| part * piece.moments().iter().sum::<f64>())
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
