//! A facet clipped by a simplex.
//!
//! The clipped piece is convex and is kept in the facet's barycentric coordinates, on which shape functions are linear.
//! The distance of the facet's corners from a plane of the simplex is computed from the plane's points in an order that
//! depends on their coordinates only, so that two simplices that share a face get the same number with opposite sign and
//! no part of a facet is counted twice or lost between them, whatever the rounding.

use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::facet::{area_vector, determinant};

/// A convex piece of a facet.
#[derive(Clone, Debug)]
pub(crate) struct Piece<const D: usize> {
    /// ∫ over the piece of every barycentric coordinate, in units of the facet's measure.
    pub(crate) moments: [f64; D],
    /// Corners, in the facet's barycentric coordinates.
    corners: Vec<[f64; D]>,
}

impl<const D: usize> Piece<D> {
    /// Corners in space, given those of the facet.
    pub(crate) fn places(&self, facet: &[Vector<D>; D]) -> impl Iterator<Item = Vector<D>> {
        let facet = *facet;
        self.corners.iter().map(move |w| (0..D).fold(Vector::zeros(), |x, a| x + facet[a] * w[a]))
    }
}

/// A triangle (2D) or tetrahedron (3D) with D + 1 corners; face k lies opposite to corner k.
#[derive(Clone, Debug)]
pub(crate) struct Simplex<const D: usize> {
    planes: Vec<Plane<D>>,
    /// +1, or −1 where its corners run the other way and what it covers is to be subtracted.
    pub(crate) sign: f64,
}

/// A face and which side of it is outside.
#[derive(Clone, Debug)]
struct Plane<const D: usize> {
    points: [Vector<D>; D],
    /// Turns the determinant with the points into the distance, positive outside.
    outward: f64,
    /// Whether the face lies on the boundary of its body.
    boundary: bool,
}

impl<const D: usize> Simplex<D> {
    /// Simplex with these corners; `boundary(k)` tells whether the face opposite to corner k bounds the body.
    /// `None` if it is flat.
    pub(crate) fn new(corners: &[Vector<D>], boundary: impl Fn(usize) -> bool) -> Option<Self> {
        let edges: [Vector<D>; D] = std::array::from_fn(|k| corners[k + 1] - corners[0]);
        let volume = determinant(&edges);
        let mut planes = Vec::with_capacity(D + 1);
        for k in 0..=D {
            let mut points: [Vector<D>; D] = std::array::from_fn(|p| corners[p + usize::from(p >= k)]);
            points.sort_by(|x, y| {
                let differing = (0..D).map(|i| x[i].total_cmp(&y[i])).find(|o| o.is_ne());
                differing.unwrap_or(std::cmp::Ordering::Equal)
            });
            let opposite = height(&points, &corners[k]);
            if opposite == 0.0 {
                return None;
            }
            let measure = area_vector(&points).norm() * (D - 1) as f64;
            planes.push(Plane { points, outward: -opposite.signum() / measure, boundary: boundary(k) });
        }
        (volume != 0.0).then(|| Self { planes, sign: volume.signum() })
    }

    /// The piece of a facet inside; `None` if empty.
    ///
    /// Distances up to `tie` are rounding and count as zero. A facet that lies in a face of the simplex counts half, so that the two simplices at an inner face make one
    /// whole, and identical bodies share; but it counts nothing where it lies on the outside of a body's boundary:
    /// the bodies touch there.
    pub(crate) fn clip(&self, corners: &[Vector<D>; D], area: &Vector<D>, tie: f64) -> Option<Piece<D>> {
        let mut piece = whole::<D>();
        let mut part = 1.0;
        for plane in &self.planes {
            let mut distance = [0.0; D];
            for (s, x) in distance.iter_mut().zip(corners) {
                let exact = plane.outward * height(&plane.points, x);
                *s = if exact.abs() <= tie { 0.0 } else { exact };
            }
            if distance.iter().all(|&s| s == 0.0) {
                let inner = plane.points[0] + area;
                let same_way = plane.outward * height(&plane.points, &inner) > 0.0;
                if plane.boundary && !same_way {
                    return None;
                }
                part = 0.5;
                continue;
            }
            if distance.iter().all(|&s| s >= 0.0) {
                return None;
            }
            if distance.iter().any(|&s| s > 0.0) {
                piece = cut(&piece, &distance);
                if piece.len() < D {
                    return None;
                }
            }
        }
        Some(Piece { moments: integrate(&piece).map(|x| x * part), corners: piece })
    }
}

/// D! times the volume over the face's points, to `x`.
fn height<const D: usize>(points: &[Vector<D>; D], x: &Vector<D>) -> f64 {
    determinant(&std::array::from_fn(|k| if k + 1 < D { points[k + 1] - points[0] } else { x - points[0] }))
}

/// Part of a convex polygon (2D: interval) where the linear function with these corner values is at most 0.
pub(super) fn cut<const D: usize>(piece: &[[f64; D]], corner: &[f64; D]) -> Vec<[f64; D]> {
    let value = |w: &[f64; D]| (0..D).map(|a| w[a] * corner[a]).sum::<f64>();
    let mut kept: Vec<[f64; D]> = Vec::with_capacity(piece.len() + 1);
    // An interval has one side, a polygon as many as corners.
    let sides = if D == 2 { piece.len().saturating_sub(1) } else { piece.len() };
    for k in 0..piece.len() {
        let (p, q) = (&piece[k], &piece[(k + 1) % piece.len()]);
        let (s, t) = (value(p), value(q));
        if s <= 0.0 {
            kept.push(*p);
        }
        if k < sides && (s < 0.0 && t > 0.0 || s > 0.0 && t < 0.0) {
            kept.push(std::array::from_fn(|a| p[a] + s / (s - t) * (q[a] - p[a])));
        }
    }
    kept
}

/// ∫ of the barycentric coordinates over a polygon (2D: interval), the whole facet having measure 1.
fn integrate<const D: usize>(piece: &[[f64; D]]) -> [f64; D] {
    let mut sums = [0.0; D];
    match D {
        2 => {
            let (p, q) = (&piece[0], &piece[1]);
            let length = (q[1] - p[1]).abs();
            for a in 0..D {
                sums[a] = length * 0.5 * (p[a] + q[a]);
            }
        }
        _ => {
            let p = &piece[0];
            for k in 1..piece.len() - 1 {
                let (q, r) = (&piece[k], &piece[k + 1]);
                let area = ((q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1])).abs();
                for a in 0..D {
                    sums[a] += area * (p[a] + q[a] + r[a]) / 3.0;
                }
            }
        }
    }
    sums
}

/// Part of a facet below a plane, given the heights of its corners; as [`Simplex::clip`].
pub(crate) fn clip_below<const D: usize>(heights: &[f64; D], tie: f64) -> Option<Piece<D>> {
    let heights = heights.map(|s| if s.abs() <= tie { 0.0 } else { s });
    if heights.iter().all(|&s| s >= 0.0) {
        return None;
    }
    let piece = cut(&whole(), &heights);
    (piece.len() >= D).then(|| Piece { moments: integrate(&piece), corners: piece })
}

/// Box around the part of a facet that lies in `region`; empty if none does.
pub(crate) fn clip_to_box<const D: usize>(corners: &[Vector<D>; D], region: &Aabb<D>) -> Aabb<D> {
    let mut piece = whole::<D>();
    for axis in 0..D {
        for heights in [corners.map(|x| x[axis] - region.max[axis]), corners.map(|x| region.min[axis] - x[axis])] {
            piece = cut(&piece, &heights);
            if piece.is_empty() {
                return Aabb::empty();
            }
        }
    }
    let piece = Piece { moments: [0.0; D], corners: piece };
    Aabb::of(&piece.places(corners).collect::<Vec<_>>())
}

/// The corners of a facet in its own barycentric coordinates.
pub(super) fn whole<const D: usize>() -> Vec<[f64; D]> {
    (0..D).map(|a| std::array::from_fn(|b| f64::from(u8::from(a == b)))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_a_triangle() {
        let parts = clip_below::<3>(&[-1.0, 1.0, -1.0], 0.0).map(|p| p.moments).unwrap_or_default();
        // The cut-off corner is a quarter of the triangle, with moments (1/2·…): area 1/4, means 1/6, 2/3, 1/6.
        let expected = [1.0 / 3.0 - 1.0 / 24.0, 1.0 / 3.0 - 1.0 / 6.0, 1.0 / 3.0 - 1.0 / 24.0];
        for a in 0..3 {
            assert!((parts[a] - expected[a]).abs() < 1e-15, "{parts:?}");
        }
        assert_eq!(clip_below::<2>(&[-1.0, 3.0], 0.0).map(|p| p.moments), Some([0.25 * 0.875, 0.25 * 0.125]));
    }

    #[test]
    fn facet_in_an_inner_face_counts_once() {
        let v = |x, y| Vector::<2>::new(x, y);
        let facet = [v(0.3, 0.0), v(0.6, 0.0)];
        let area = v(0.0, -0.3);
        let of = |corners: &[Vector<2>], boundary: bool| {
            let simplex = Simplex::new(corners, |_| boundary);
            simplex.and_then(|s| s.clip(&facet, &area, 0.0)).map_or(0.0, |p| p.moments.iter().sum())
        };
        let (above, below) = ([v(0.0, 0.0), v(1.0, 0.0), v(0.0, 1.0)], [v(0.0, 0.0), v(0.0, -1.0), v(1.0, 0.0)]);
        assert_eq!(of(&above, false) + of(&below, false), 1.0);
        // Normal of the facet points down: it lies on the boundary of `above` the same way, and touches `below`.
        assert_eq!((of(&above, true), of(&below, true)), (0.5, 0.0));
    }
}
