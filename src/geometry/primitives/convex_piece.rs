//! A convex piece of a facet, cut plane by plane.
//!
//! It is kept in the facet's barycentric coordinates, on which shape functions are linear.

use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use smallvec::SmallVec;

/// Corners of a convex piece in a facet's barycentric coordinates. Few have more than eight, which take no memory elsewhere.
pub(crate) type Corners<const D: usize> = SmallVec<[[f64; D]; 8]>;

/// A convex polygon (2D: interval) in a facet; its memory serves one facet after the other.
#[derive(Clone, Debug, Default)]
pub(crate) struct Piece<const D: usize> {
    corners: Vec<[f64; D]>,
    /// The corners before the last cut, and the values of its linear function there.
    before: Vec<[f64; D]>,
    values: Vec<f64>,
}

impl<const D: usize> Piece<D> {
    /// Makes it the whole facet.
    pub(crate) fn reset(&mut self) {
        self.corners.clear();
        self.corners.extend(corners_of_whole::<D>());
    }

    /// Makes it this piece.
    pub(crate) fn set(&mut self, corners: &[[f64; D]]) {
        self.corners.clear();
        self.corners.extend_from_slice(corners);
    }

    /// Keeps the part where the linear function with these values at the facet's corners is at most 0; false if no part
    /// is left.
    pub(crate) fn cut(&mut self, at_corners: &[f64; D]) -> bool {
        std::mem::swap(&mut self.corners, &mut self.before);
        self.corners.clear();
        self.values.clear();
        self.values.extend(self.before.iter().map(|w| value(w, at_corners)));
        cut_to(&self.before, &self.values, |corner| self.corners.push(corner));
        self.corners.len() >= D
    }

    /// ∫ over the piece of every barycentric coordinate, the whole facet having measure 1.
    pub(crate) fn moments(&self) -> [f64; D] {
        let mut sums = [0.0; D];
        match D {
            2 => {
                let (p, q) = (&self.corners[0], &self.corners[1]);
                let length = (q[1] - p[1]).abs();
                for a in 0..D {
                    sums[a] = length * 0.5 * (p[a] + q[a]);
                }
            }
            _ => {
                let p = &self.corners[0];
                for pair in self.corners[1..].windows(2) {
                    let (q, r) = (&pair[0], &pair[1]);
                    let area = ((q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1])).abs();
                    for a in 0..D {
                        sums[a] += area * (p[a] + q[a] + r[a]) / 3.0;
                    }
                }
            }
        }
        sums
    }

    /// Corners, in the facet's barycentric coordinates.
    pub(crate) fn corners(&self) -> &[[f64; D]] {
        &self.corners
    }
}

/// Value of the linear function with these values at the facet's corners.
pub(crate) fn value<const D: usize>(w: &[f64; D], at_corners: &[f64; D]) -> f64 {
    (0..D).map(|a| w[a] * at_corners[a]).sum()
}

/// Visits the corners of the part of a polygon where `values` are at most 0.
fn cut_to<const D: usize>(corners: &[[f64; D]], values: &[f64], mut keep: impl FnMut([f64; D])) {
    let count = corners.len();
    // An interval has one side, a polygon as many as corners.
    let sides = if D == 2 { count.saturating_sub(1) } else { count };
    for k in 0..count {
        let next = if k + 1 < count { k + 1 } else { 0 };
        let (p, q) = (&corners[k], &corners[next]);
        let (s, t) = (values[k], values[next]);
        if s <= 0.0 {
            keep(*p);
        }
        if k < sides && (s < 0.0 && t > 0.0 || s > 0.0 && t < 0.0) {
            let part = s / (s - t);
            keep(std::array::from_fn(|a| p[a] + part * (q[a] - p[a])));
        }
    }
}

fn corners_of_whole<const D: usize>() -> [[f64; D]; D] {
    std::array::from_fn(|a| std::array::from_fn(|b| f64::from(u8::from(a == b))))
}

/// The corners of a facet in its own barycentric coordinates.
pub(crate) fn whole<const D: usize>() -> Corners<D> {
    Corners::from_slice(&corners_of_whole())
}

/// Part of a convex polygon (2D: interval) where the linear function with these corner values is at most 0; as
/// [`Piece::cut`], for pieces that are kept.
pub(crate) fn cut<const D: usize>(piece: &[[f64; D]], at_corners: &[f64; D]) -> Corners<D> {
    let values: SmallVec<[f64; 8]> = piece.iter().map(|w| value(w, at_corners)).collect();
    let mut kept = Corners::new();
    cut_to(piece, &values, |corner| kept.push(corner));
    kept
}

/// Points on the boundary of a convex piece (2D: in an interval) where a linear function, given at the facet's corners,
/// passes through zero: one in 2D, two in 3D, or none.
pub(crate) fn zeros<const D: usize>(piece: &[[f64; D]], corner: &[f64; D]) -> Vec<[f64; D]> {
    let sides = if D == 2 { piece.len().saturating_sub(1) } else { piece.len() };
    let mut zeros = Vec::new();
    for k in 0..sides {
        let (p, q) = (&piece[k], &piece[(k + 1) % piece.len()]);
        let (s, t) = (value(p, corner), value(q, corner));
        if (s < 0.0) != (t < 0.0) {
            zeros.push(std::array::from_fn(|a| p[a] + s / (s - t) * (q[a] - p[a])));
        }
    }
    zeros
}

/// Where a point with barycentric coordinates `w` lies in a facet.
pub(crate) fn place<const D: usize>(facet: &[Vector<D>; D], w: &[f64; D]) -> Vector<D> {
    (0..D).fold(Vector::zeros(), |x, a| x + facet[a] * w[a])
}

/// Cuts the part of a facet below a plane out of it, given the heights of its corners; those up to the tolerance are
/// rounding and count as zero. False if no part lies below.
pub(crate) fn clip_below<const D: usize>(heights: &[f64; D], tolerance: f64, piece: &mut Piece<D>) -> bool {
    let heights = heights.map(|s| if s.abs() <= tolerance { 0.0 } else { s });
    if heights.iter().all(|&s| s >= 0.0) {
        return false;
    }
    piece.reset();
    heights.iter().all(|&s| s <= 0.0) || piece.cut(&heights)
}

/// Box around the part of a facet that lies in `region`; empty if none does.
pub(crate) fn clip_to_box<const D: usize>(corners: &[Vector<D>; D], region: &Aabb<D>, piece: &mut Piece<D>) -> Aabb<D> {
    piece.reset();
    for axis in 0..D {
        for heights in [corners.map(|x| x[axis] - region.max[axis]), corners.map(|x| region.min[axis] - x[axis])] {
            if heights.iter().any(|&s| s > 0.0) {
                piece.cut(&heights);
                if piece.corners.is_empty() {
                    return Aabb::empty();
                }
            }
        }
    }
    piece.corners.iter().fold(Aabb::empty(), |aabb, w| {
        let x = place(corners, w);
        Aabb { min: aabb.min.inf(&x), max: aabb.max.sup(&x) }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_a_triangle() {
        let mut piece = Piece::default();
        assert!(clip_below::<3>(&[-1.0, 1.0, -1.0], 0.0, &mut piece));
        let parts = piece.moments();
        // The cut-off corner is a quarter of the triangle, with moments (1/2·…): area 1/4, means 1/6, 2/3, 1/6.
        let expected = [1.0 / 3.0 - 1.0 / 24.0, 1.0 / 3.0 - 1.0 / 6.0, 1.0 / 3.0 - 1.0 / 24.0];
        for a in 0..3 {
            assert!((parts[a] - expected[a]).abs() < 1e-15, "{parts:?}");
        }
        let mut piece = Piece::default();
        let parts = clip_below::<2>(&[-1.0, 3.0], 0.0, &mut piece).then(|| piece.moments());
        assert_eq!(parts, Some([0.25 * 0.875, 0.25 * 0.125]));
    }

    /// What six planes leave of a triangle that fills the plane z = 0: the middle cut of the box.
    #[test]
    fn box_around_the_part_in_a_box() {
        let v = Vector::<3>::new;
        let facet = [v(-9.0, -9.0, 0.0), v(18.0, -9.0, 0.0), v(-9.0, 18.0, 0.0)];
        let region = Aabb { min: v(-1.0, -2.0, -3.0), max: v(1.0, 2.0, 3.0) };
        let mut piece = Piece::default();
        let found = clip_to_box(&facet, &region, &mut piece);
        let expected = Aabb { min: v(-1.0, -2.0, 0.0), max: v(1.0, 2.0, 0.0) };
        assert!((found.min - expected.min).amax() < 1e-13 && (found.max - expected.max).amax() < 1e-13, "{found:?}");
        // Four of the six planes cut; a quadrilateral of 8 is left of 27²/2.
        assert!((piece.moments().iter().sum::<f64>() * 364.5 - 8.0).abs() < 1e-12);
        assert!(clip_to_box(&facet.map(|x| x + v(0.0, 0.0, 4.0)), &region, &mut piece).is_empty());
    }

    #[test]
    fn zeros_of_a_triangle() {
        let found = zeros::<3>(&whole(), &[-1.0, 1.0, 3.0]);
        assert_eq!(found, [[0.5, 0.5, 0.0], [0.75, 0.0, 0.25]]);
        assert_eq!(zeros::<2>(&whole(), &[-1.0, 3.0]), [[0.75, 0.25]]);
        assert!(zeros::<2>(&whole(), &[1.0, 3.0]).is_empty());
    }
}
