//! On which side of a plane a point lies, and how far, however close the two are.
//!
//! The signed volume of a simplex by products of coordinates is wrong by rounding of the size of its box. For a simplex
//! that is nearly flat this is more than its volume: facets that lie in one plane but for rounding are such simplices,
//! and where they cross follows from the ratio of these volumes. So they are computed with twice the digits there, and
//! where that is not enough either, exact arithmetic decides the sign (Shewchuk, Discrete Comput. Geom. 18, 1997, as the
//! crate `robust` has it).

use super::facet::determinant;
use crate::geometry::Vector;

/// Below this part of its bound a determinant has lost so many digits that it is computed anew: above, its error is at
/// most 1e-10 of it.
pub(crate) const DOUBTFUL: f64 = 1e-5;

/// A determinant with twice the digits has an error of some 1e-31 of its bound; smaller ones than this are decided
/// exactly.
const UNDECIDED: f64 = 1e-28;

/// det [points_k − points_0, x − points_0]: twice the area of a triangle, six times the volume of a tetrahedron.
///
/// Its leading digits and its sign are right, and it is zero only if the points lie in a plane.
pub(crate) fn orientation<const D: usize>(points: &[Vector<D>; D], x: &Vector<D>) -> f64 {
    let last = x - points[0];
    let rows = std::array::from_fn(|k| if k + 1 < D { points[k + 1] - points[0] } else { last });
    let value = determinant(&rows);
    if value.abs() > DOUBTFUL * bound(points, size(&last)) { value } else { precise_orientation(points, x) }
}

/// Size of the products of which the determinant is a sum, for a point at this distance from the first of `points`.
/// Distances are sums of sizes of coordinates.
pub(crate) fn bound<const D: usize>(points: &[Vector<D>; D], distance: f64) -> f64 {
    points[1..].iter().fold(distance, |product, x| product * size(&(x - points[0])))
}

/// Sum of the sizes of coordinates.
pub(crate) fn size<const D: usize>(x: &Vector<D>) -> f64 {
    x.iter().fold(0.0, |sum, x| sum + x.abs())
}

/// The same as [`orientation`] where it is known that digits are lost.
#[cold]
pub(crate) fn precise_orientation<const D: usize>(points: &[Vector<D>; D], x: &Vector<D>) -> f64 {
    let bound = bound(points, size(&(x - points[0])));
    if !bound.is_finite() {
        return bound;
    }
    let row = |to: &Vector<D>| -> [Twofold; D] { std::array::from_fn(|i| Twofold::difference(to[i], points[0][i])) };
    let (e, g) = (row(&points[1]), row(x));
    let value = match D {
        2 => e[0].times(g[1]).minus(e[1].times(g[0])),
        _ => {
            let f = row(&points[D - 1]);
            let minor = |i: usize, j: usize| e[i].times(f[j]).minus(e[j].times(f[i]));
            minor(1, 2).times(g[0]).plus(minor(2, 0).times(g[1])).plus(minor(0, 1).times(g[2]))
        }
    }
    .value();
    if value.abs() > UNDECIDED * bound { value } else { value.abs().max(f64::MIN_POSITIVE) * sign(points, x) }
}

/// Sign of the same determinant, 0 where the points lie in a plane.
fn sign<const D: usize>(points: &[Vector<D>; D], x: &Vector<D>) -> f64 {
    let exact = match D {
        2 => {
            let [a, b, c] = [&points[0], &points[1], x].map(|p| robust::Coord { x: p[0], y: p[1] });
            robust::orient2d(a, b, c)
        }
        _ => {
            let at = |p: &Vector<D>| robust::Coord3D { x: p[0], y: p[1], z: p[2] };
            -robust::orient3d(at(&points[0]), at(&points[1]), at(&points[D - 1]), at(x))
        }
    };
    if exact == 0.0 { 0.0 } else { exact.signum() }
}

/// The sum of two numbers, the second a rounding error of the first (Dekker, Numer. Math. 18, 1971).
#[derive(Clone, Copy)]
struct Twofold {
    high: f64,
    low: f64,
}

impl Twofold {
    /// a + b, exactly.
    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let of_b = high - a;
        Self { high, low: (a - (high - of_b)) + (b - of_b) }
    }

    /// a − b, exactly.
    fn difference(a: f64, b: f64) -> Self {
        Self::sum(a, -b)
    }

    fn times(self, other: Self) -> Self {
        let high = self.high * other.high;
        let low = self.high.mul_add(other.high, -high) + (self.high * other.low + self.low * other.high);
        Self::sum(high, low)
    }

    fn plus(self, other: Self) -> Self {
        let (high, low) = (Self::sum(self.high, other.high), Self::sum(self.low, other.low));
        let high = Self::sum(high.high, high.low + low.high);
        Self::sum(high.high, high.low + low.low)
    }

    fn minus(self, other: Self) -> Self {
        self.plus(Self { high: -other.high, low: -other.low })
    }

    fn value(self) -> f64 {
        self.high + self.low
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fmc_shapes::Splitmix;

    /// Points of a plane at integers, one of them moved off it by a part of what rounding hides.
    #[test]
    fn heights_below_rounding_have_their_digits() {
        let mut random = Splitmix::new(3);
        for _ in 0..2_000 {
            let mut at = || random.between(-40.0, 40.0).round();
            // z = (3 x − 5 y) / 4.
            let mut point = || {
                let (x, y) = (at(), at());
                Vector::<3>::new(x, y, 0.75 * x - 1.25 * y)
            };
            let points = [point(), point(), point()];
            let on = point();
            assert_eq!(orientation(&points, &on), 0.0);
            let e = points[1] - points[0];
            let f = points[2] - points[0];
            // The last of the normal's coordinates, an integer.
            let normal = e[0] * f[1] - e[1] * f[0];
            for height in [1e-3, 1e-14, 1e-15, -1e-15, -1e-9] {
                let above = Vector::<3>::new(on[0], on[1], on[2] + height);
                let exact = normal * (above[2] - on[2]);
                assert!((orientation(&points, &above) - exact).abs() <= 1e-10 * exact.abs(), "{points:?} {above:?}");
            }
        }
    }

    /// A height of 1e-40 beside coordinates of one: no digits of sums of products tell it.
    #[test]
    fn the_smallest_heights_have_their_sign() {
        let v = Vector::<3>::new;
        let points = [v(1.0, 1.0, 0.0), v(3.0, 1.0, 0.0), v(1.0, 2.0, 0.0)];
        for height in [1e-40, -1e-40, 1e-300] {
            assert_eq!(orientation(&points, &v(0.3, 0.4, height)).signum(), f64::signum(height));
        }
        let line = [Vector::<2>::new(0.1, 0.1), Vector::<2>::new(0.3, 0.3)];
        assert_eq!(orientation(&line, &Vector::<2>::new(0.7, 0.7)), 0.0);
        assert!(orientation(&line, &Vector::<2>::new(0.7, 0.7f64.next_up())) > 0.0);
        assert!(orientation(&line, &Vector::<2>::new(0.7f64.next_up(), 0.7)) < 0.0);
    }
}
