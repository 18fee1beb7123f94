//! The normal of a facet with axes in its plane, and how they turn as its corners move.
//!
//! The first axis e is the direction of a combination of the corners that stays with the material; in 3D the second is n × e, so that
//! a·d²(n × e) = (e × a)·d²n + (a × n)·d²e + a·(dn × δe + δn × de).

use super::broken_friction::Edges;
use super::frame::{Frame, Matrix};
use crate::geometry::Vector;

/// Sine of the angle between normal and x axis below which the z axis is projected: 0.1°.
const ALONG_X: f64 = 1.745e-3;

/// Normal and axes.
pub(super) struct Axes<const D: usize> {
    pub(super) units: [Vector<D>; D],
    /// By axis and corner.
    pub(super) slopes: [[Matrix<D>; D]; D],
    normal: Frame<D>,
    first: Frame<D>,
}

/// The combination of corners that gives the first axis of a facet without deformation, its shares; they are 0 where it has no area.
pub(super) fn shares_of_axis<const D: usize>(x: &[Vector<D>; D]) -> [f64; D] {
    let mut shares = [0.0; D];
    if D == 2 {
        (shares[0], shares[1]) = (-1.0, 1.0);
        return shares;
    }
    let axis = |number: usize| Vector::<D>::from_fn(|i, _| f64::from(i == number));
    let is_along_x = Frame::new(x).is_some_and(|frame| {
        let normal = &frame.normal;
        (axis(0) - normal * normal[0]).norm() < ALONG_X
    });
    if let Some(edges) = Edges::new(x) {
        let multiples = edges.multiples(&axis(if is_along_x { 2 } else { 0 }));
        for (corner, multiple) in (1..D).zip(multiples) {
            shares[corner] = multiple;
            shares[0] -= multiple;
        }
    }
    shares
}

impl<const D: usize> Axes<D> {
    /// Of a facet with these corners; `None` where it has no area.
    pub(super) fn new(x: &[Vector<D>; D], shares: &[f64; D]) -> Option<Self> {
        let (normal, first) = (Frame::new(x)?, Frame::toward(x, shares)?);
        let (mut units, mut slopes) = ([normal.normal; D], [normal.slopes; D]);
        (units[1], slopes[1]) = (first.normal, first.slopes);
        if D == 3 {
            units[2] = cross(&normal.normal, &first.normal);
            for (corner, slope) in slopes[2].iter_mut().enumerate() {
                for j in 0..D {
                    let [dn, de] = [&normal, &first].map(|frame| column(&frame.slopes[corner], j));
                    let turned = cross(&dn, &first.normal) + cross(&normal.normal, &de);
                    (0..D).for_each(|i| slope[i][j] = turned[i]);
                }
            }
        }
        Some(Self { units, slopes, normal, first })
    }

    /// Σ t_i a·e_i, its second derivative by the positions of two corners.
    pub(super) fn second(&self, a: &Vector<D>, t: &[f64; D], corners: [usize; 2]) -> Matrix<D> {
        let (mut by_normal, mut by_first) = (a * t[0], a * t[1]);
        if D == 3 {
            by_normal += cross(&self.first.normal, a) * t[2];
            by_first += cross(a, &self.normal.normal) * t[2];
        }
        let mut found = self.normal.second(&by_normal, corners);
        let of_first = self.first.second(&by_first, corners);
        let columns = |frame: &Frame<D>, corner: usize| -> [Vector<D>; D] {
            std::array::from_fn(|j| column(&frame.slopes[corner], j))
        };
        let [n, e] = [&self.normal, &self.first].map(|frame| corners.map(|corner| columns(frame, corner)));
        for i in 0..D {
            for j in 0..D {
                found[i][j] += of_first[i][j];
                if D == 3 {
                    found[i][j] += t[2] * a.dot(&(cross(&n[0][i], &e[1][j]) + cross(&n[1][j], &e[0][i])));
                }
            }
        }
        found
    }
}

fn column<const D: usize>(matrix: &Matrix<D>, j: usize) -> Vector<D> {
    Vector::from_fn(|i, _| matrix[i][j])
}

/// Of vectors in space.
fn cross<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> Vector<D> {
    Vector::from_fn(|i, _| {
        let (j, k) = ((i + 1) % D, (i + 2) % D);
        a[j] * b[k] - a[k] * b[j]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [[f64; 3]; 3] = [[0.1, 0.2, -0.4], [1.2, 0.1, 0.3], [-0.2, 0.8, 0.6]];

    /// Central differences with a step of 1e-6 are exact to 1e-9 or so.
    #[test]
    fn derivatives_against_differences() {
        let x = CORNERS.map(Vector::<3>::from);
        let shares = shares_of_axis(&x);
        let (a, t, step) = (Vector::<3>::new(0.4, 1.3, -0.7), [0.3, -0.8, 1.1], 1e-6);
        let moved = |c: usize, i: usize, by: f64| {
            let mut x = x;
            x[c][i] += by;
            Axes::new(&x, &shares).expect("a facet with an area")
        };
        let axes = Axes::new(&x, &shares).expect("a facet with an area");
        let first = |axes: &Axes<3>, d: usize, j: usize| -> f64 {
            (0..3).map(|axis| t[axis] * a.dot(&column(&axes.slopes[axis][d], j))).sum()
        };
        for (c, i) in (0..9).map(|k| (k / 3, k % 3)) {
            let [more, less] = [step, -step].map(|by| moved(c, i, by));
            for axis in 0..3 {
                let slope = (more.units[axis] - less.units[axis]) / (2.0 * step);
                assert!((slope - column(&axes.slopes[axis][c], i)).norm() < 1e-8);
            }
            for (d, j) in (0..9).map(|k| (k / 3, k % 3)) {
                let second = (first(&more, d, j) - first(&less, d, j)) / (2.0 * step);
                assert!((second - axes.second(&a, &t, [c, d])[i][j]).abs() < 1e-7);
            }
        }
    }

    /// Rounding.
    #[test]
    fn the_first_axis_is_the_x_axis_projected_and_all_are_a_right_handed_frame() {
        let x = CORNERS.map(Vector::<3>::from);
        let axes = Axes::new(&x, &shares_of_axis(&x)).expect("a facet with an area");
        let [n, e, f] = axes.units;
        let projected = (Vector::<3>::x() - n * n[0]).normalize();
        assert!((e - projected).norm() < 1e-14 && n.dot(&e).abs() < 1e-14 && (n.cross(&e) - f).norm() < 1e-14);
        let upright = [[2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [2.0, 0.3, 1.0]].map(Vector::<3>::from);
        let axes = Axes::new(&upright, &shares_of_axis(&upright)).expect("a facet with an area");
        assert!((axes.units[1] - Vector::<3>::z()).norm() < 1e-14);
        let edge = [Vector::<2>::new(1.0, 0.0), Vector::<2>::new(0.0, 0.0)];
        let axes = Axes::new(&edge, &shares_of_axis(&edge)).expect("an edge");
        assert!(axes.units == [Vector::<2>::new(0.0, 1.0), Vector::<2>::new(-1.0, 0.0)]);
    }
}
