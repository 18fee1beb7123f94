//! Depths along rays from a corner of a triangle, and between which of them an integral over the rays is smooth.

use super::parabola::{Marks, complex_roots, crossings, quadratic, quadratic_through, value};
use smallvec::SmallVec;

/// Gauss' points on an interval of length 1 about 0, and their weights: degree 9.
pub(super) const GAUSS: [(f64, f64); 5] = [
    (-0.453_089_922_969_332, 0.118_463_442_528_094_54),
    (-0.269_234_655_052_841_55, 0.239_314_335_249_683_23),
    (0.0, 64.0 / 225.0),
    (0.269_234_655_052_841_55, 0.239_314_335_249_683_23),
    (0.453_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Intervals of rays are halved where a root lies within an ellipse about them, with axes whose sum is this many times half of it: the error of
/// Gauss' points is then some 1e-7 of what is crossed; and how often.
const NEAR: f64 = 4.0;
const HALVINGS: usize = 5;

/// How far from the middle of a ray it touches a level, in its lengths, where that is seen on it.
const ON_RAY: f64 = 0.75;

/// Roots of discriminants, real and imaginary part.
type Touches = SmallVec<[[f64; 2]; 6]>;

/// Depths along rays from a corner, c + b r + a r², each coefficient a quadratic function of where the ray meets the far edge.
pub(super) struct Rays {
    of_ray: [[f64; 3]; 3],
}

/// Levels that are crossed.
pub(super) type Levels = SmallVec<[f64; 3]>;

impl Rays {
    /// From the depths along three of them: at both ends of the far edge, and in its middle.
    pub(super) fn new(rays: [[f64; 3]; 3]) -> Self {
        Self { of_ray: std::array::from_fn(|k| quadratic_through(rays.map(|ray| ray[k]))) }
    }

    pub(super) fn at(&self, t: f64) -> [f64; 3] {
        self.of_ray.map(|coefficients| value(&coefficients, t))
    }

    /// Where rays are parted: where a level leaves through the far edge, and so that Gauss' points see no ray that touches a level, near which
    /// the integral is the power 3/2 of the distance.
    pub(super) fn parted(&self, levels: &[f64]) -> Marks {
        let end = |t: f64| self.at(t).iter().sum::<f64>();
        let mut marks = crossings(&quadratic(end), levels);
        let mut touches = Touches::new();
        for level in levels {
            let discriminant = |t: f64| {
                let [c, b, a] = self.at(t);
                b * b - 4.0 * a * (c - level)
            };
            let is_on_ray = |[t, _]: &[f64; 2]| {
                let [_, b, a] = self.at(*t);
                (-0.5 * b / a - 0.5).abs() < ON_RAY
            };
            touches.extend(complex_roots(quadratic(discriminant)).filter(is_on_ray));
        }
        let inside = touches.iter().filter(|[t, aside]| *aside == 0.0 && 0.0 < *t && *t < 1.0);
        marks.extend(inside.map(|[t, _]| *t));
        marks.sort_unstable_by(f64::total_cmp);
        let mut parted = Marks::from_slice(&[0.0]);
        marks.windows(2).for_each(|pair| halve([pair[0], pair[1]], &touches, HALVINGS, &mut parted));
        parted
    }
}

/// Adds where an interval ends, and where it is halved on the way.
fn halve([from, to]: [f64; 2], touches: &Touches, halvings: usize, parted: &mut Marks) {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    // The ellipse about both ends through a root.
    let is_near = |[t, aside]: &[f64; 2]| (t - from).hypot(*aside) + (t - to).hypot(*aside) < NEAR * half;
    if halvings > 0 && touches.iter().any(is_near) {
        halve([from, middle], touches, halvings - 1, parted);
        halve([middle, to], touches, halvings - 1, parted);
    } else {
        parted.push(to);
    }
}
