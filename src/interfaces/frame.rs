//! How the unit normal of a facet, or a direction in its plane, turns as its corners move.
//!
//! With the area vector N, n = N/|N| and P = I − n nᵀ: dn = P dN/|N|, and for a fixed vector a, with t = P a,
//! d²(a·n) = [t·d²N]/|N| − [(n·dN)(t·δN) + (n·δN)(t·dN) + (a·n) dN·P δN]/|N|². A direction has a sum over the corners in place of N.

use crate::geometry::Vector;
use crate::geometry::primitives::facet::{area_slopes, area_vector};

/// A D by D matrix, row by row.
pub(super) type Matrix<const D: usize> = [[f64; D]; D];

/// The normal of a facet, or a direction in its plane, and its derivatives.
pub(super) struct Frame<const D: usize> {
    pub(super) normal: Vector<D>,
    /// By the position of every corner.
    pub(super) slopes: [Matrix<D>; D],
    /// Those of the area vector.
    of_area: [Matrix<D>; D],
    area: f64,
    /// Whether the area vector bends, as that of a normal in space does.
    bends: bool,
}

impl<const D: usize> Frame<D> {
    /// That of a facet with these corners; `None` where it has no area.
    pub(super) fn new(x: &[Vector<D>; D]) -> Option<Self> {
        Self::of(area_vector(x), area_slopes(x), D == 3)
    }

    /// The direction of Σ share · corner, whose shares sum up to 0; `None` where that has no length.
    pub(super) fn toward(x: &[Vector<D>; D], shares: &[f64; D]) -> Option<Self> {
        let vector = x.iter().zip(shares).fold(Vector::zeros(), |sum, (x, share)| sum + x * *share);
        let diagonal = |share: f64| std::array::from_fn(|i| std::array::from_fn(|j| if i == j { share } else { 0.0 }));
        Self::of(vector, shares.map(diagonal), false)
    }

    fn of(vector: Vector<D>, of_area: [Matrix<D>; D], bends: bool) -> Option<Self> {
        let area = vector.norm();
        let normal = vector.try_normalize(0.0)?;
        let slopes = of_area.map(|slope| {
            let column = |j: usize| Vector::<D>::from_fn(|i, _| slope[i][j]);
            let turned: [Vector<D>; D] = std::array::from_fn(|j| across(&column(j), &normal) / area);
            std::array::from_fn(|i| std::array::from_fn(|j| turned[j][i]))
        });
        Some(Self { normal, slopes, of_area, area, bends })
    }

    /// That of a facet that has collapsed: no normal, and none whatever moves.
    pub(super) fn none() -> Self {
        let zero = [[[0.0; D]; D]; D];
        Self { normal: Vector::zeros(), slopes: zero, of_area: zero, area: 1.0, bends: false }
    }

    /// The second derivative of a·n by the positions of two corners.
    pub(super) fn second(&self, a: &Vector<D>, corners: [usize; 2]) -> Matrix<D> {
        let (n, area) = (&self.normal, self.area);
        let along = across(a, n);
        let of = |k: usize| &self.of_area[corners[k]];
        let times = |m: &Matrix<D>, v: &Vector<D>| Vector::<D>::from_fn(|j, _| (0..D).map(|i| v[i] * m[i][j]).sum());
        let [nu, tu] = [n, &along].map(|v| times(of(0), v));
        let [nw, tw] = [n, &along].map(|v| times(of(1), v));
        let bent = if self.bends { bend(&along, corners) } else { [[0.0; D]; D] };
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let plain: f64 = (0..D).map(|k| of(0)[k][i] * of(1)[k][j]).sum();
                let turned = nu[i] * tw[j] + tu[i] * nw[j] + a.dot(n) * (plain - nu[i] * nw[j]);
                bent[i][j] / area - turned / (area * area)
            })
        })
    }
}

/// The part of v across n.
fn across<const D: usize>(v: &Vector<D>, n: &Vector<D>) -> Vector<D> {
    v - n * v.dot(n)
}

/// t·d²N in space by the positions of two corners: N is linear in each corner.
fn bend<const D: usize>(t: &Vector<D>, [c, d]: [usize; 2]) -> Matrix<D> {
    let mut found = [[0.0; D]; D];
    if c == d {
        return found;
    }
    // N = ½ Σ x_c × x_{c+1}, so that t·∂²N/∂x_c ∂x_{c+1} is ½ (u × w)·t.
    let sign = if (c + 1) % D == d { 0.5 } else { -0.5 };
    for i in 0..D {
        let (j, k) = ((i + 1) % D, (i + 2) % D);
        found[i][j] = sign * t[k];
        found[i][k] = -sign * t[j];
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<const D: usize>(x: [Vector<D>; D], a: Vector<D>, of: impl Fn(&[Vector<D>; D]) -> Option<Frame<D>>) {
        let step = 1e-6;
        let moved = |c: usize, i: usize, by: f64| {
            let mut x = x;
            x[c][i] += by;
            of(&x).expect("a facet with an area")
        };
        let frame = of(&x).expect("a facet with an area");
        for c in 0..D {
            for i in 0..D {
                let [more, less] = [step, -step].map(|by| moved(c, i, by));
                let slope = (more.normal - less.normal) / (2.0 * step);
                for k in 0..D {
                    assert!((slope[k] - frame.slopes[c][k][i]).abs() < 1e-8);
                }
                for d in 0..D {
                    let first = |frame: &Frame<D>, j: usize| (0..D).map(|k| a[k] * frame.slopes[d][k][j]).sum::<f64>();
                    for j in 0..D {
                        let second = (first(&more, j) - first(&less, j)) / (2.0 * step);
                        assert!((second - frame.second(&a, [c, d])[i][j]).abs() < 1e-7);
                    }
                }
            }
        }
    }

    /// Central differences with a step of 1e-6 are exact to 1e-9 or so.
    #[test]
    fn derivatives_of_the_normal_against_differences() {
        let (edge, a) = ([Vector::<2>::new(0.1, 0.2), Vector::<2>::new(0.9, -0.3)], Vector::<2>::new(0.4, 1.3));
        check(edge, a, Frame::new);
        check(edge, a, |x| Frame::toward(x, &[-1.0, 1.0]));
        let corners = [[0.1, 0.2, -0.4], [1.2, 0.1, 0.3], [-0.2, 0.8, 0.6]].map(Vector::<3>::from);
        let a = Vector::<3>::new(0.4, 1.3, -0.7);
        check(corners, a, Frame::new);
        check(corners, a, |x| Frame::toward(x, &[-1.3, 0.4, 0.9]));
    }
}
