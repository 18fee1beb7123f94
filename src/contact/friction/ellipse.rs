//! From the slip at a point to its traction where limits are other ones across a direction than along it.
//!
//! With the limits τ a₁ and τ a₂ the traction of a spring that is stretched too far is the point of the ellipse that is nearest to
//! τ x = k_T s: what slides then dissipates most. It is τ a∘p, |p| = 1, with
//!
//! ```text
//! p_i = a_i x_i/(a_i² + λ),   λ ≥ 0
//! ```
//!
//! 1/|p| is a concave function of λ that grows: Newton's method on it goes from λ = 0 to the root, where |p| = 1, without passing it,
//! whatever the limits. Where both are the same it is linear, and one step leads there. Tangents are along w = (−a₁p₂, a₂p₁):
//!
//! ```text
//! ∂(a∘p)/∂x = w wᵀ / (p₂² (a₁² + λ) + p₁² (a₂² + λ))
//! ```

use super::traction::{ROUNDING, Stick, Traction};
use crate::geometry::Vector;
use crate::geometry::primitives::facet_slopes::cross;
use nalgebra::SMatrix;

/// Limits along two axes, by the larger of both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ellipse<const D: usize> {
    /// Unit vectors in the tangent plane: along the direction, and across it.
    axes: [Vector<D>; 2],
    factors: [f64; 2],
}

/// A limit that is smaller than this part of the other is none: tractions are not known to so many digits, and squares do not vanish.
const NEGLIGIBLE: f64 = 1e-12;

/// Stretch, by the limit, from which on the traction is that of endless slip, to all digits.
const ENDLESS: f64 = 1e100;

/// Steps of Newton's method, many more than are needed.
const MOST_STEPS: usize = 100;

impl<const D: usize> Ellipse<D> {
    /// `along` is a unit vector in the plane across `normal`.
    pub(crate) fn new(along: Vector<D>, normal: &Vector<D>, factors: [f64; 2]) -> Self {
        let factors = factors.map(|factor| if factor < NEGLIGIBLE { 0.0 } else { factor });
        Self { axes: [along, cross(normal, &along)], factors }
    }

    /// Traction at this slip, where the larger limit is `limit`.
    pub(super) fn traction(&self, stick: Stick, limit: f64, trial: &Vector<D>) -> Traction<D> {
        match stick {
            Stick::Spring(stiffness) => self.of_spring(stiffness, limit, trial),
            Stick::Memoryless(most) => self.without_memory(most, limit, trial),
        }
    }

    fn of_spring(&self, stiffness: f64, limit: f64, trial: &Vector<D>) -> Traction<D> {
        let slip = self.parts(trial);
        let stretch = slip.map(|s| if s == 0.0 { 0.0 } else { s * stiffness / limit });
        let Some(Nearest { point, slope, by_limit, slides }) = nearest(self.factors, stretch) else {
            return Traction {
                value: trial * stiffness,
                elastic: *trial,
                slides: false,
                stiffness: SMatrix::identity() * stiffness,
                by_limit: Vector::zeros(),
                stored: 0.5 * stiffness * trial.norm_squared(),
                dissipated: 0.0,
            };
        };
        let value = self.vector(point) * limit;
        let elastic = value / stiffness;
        Traction {
            value,
            elastic,
            slides,
            stiffness: self.matrix(slope) * stiffness,
            by_limit: self.vector(by_limit),
            stored: 0.5 * value.dot(&elastic),
            dissipated: value.dot(&(trial - elastic)).max(0.0),
        }
    }

    /// The gradient of a function of m = √((a₁s₁)² + (a₂s₂)²), which is m where that is large.
    fn without_memory(&self, most: f64, limit: f64, trial: &Vector<D>) -> Traction<D> {
        let (slip, a) = (self.parts(trial), self.factors);
        let size = (a[0] * slip[0]).hypot(a[1] * slip[1]);
        let slides = size > most;
        // By m, the traction by the limit, times m; and how that grows, times m.
        let (over, growth) =
            if slides { (1.0 / size, -1.0 / size) } else { (2.0 / most - size / (most * most), -size / (most * most)) };
        let squares = a.map(|a| a * a);
        let along: [f64; 2] = std::array::from_fn(|i| if size > 0.0 { squares[i] * slip[i] / size } else { 0.0 });
        let by_limit = std::array::from_fn(|i| squares[i] * slip[i] * over);
        let slope = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                limit * (if i == j { squares[i] * over } else { 0.0 } + growth * along[i] * along[j])
            })
        });
        let by_limit = self.vector(by_limit);
        let value = by_limit * limit;
        Traction {
            value,
            elastic: Vector::zeros(),
            slides,
            stiffness: self.matrix(slope),
            by_limit,
            stored: 0.0,
            dissipated: value.dot(trial).max(0.0),
        }
    }

    fn parts(&self, x: &Vector<D>) -> [f64; 2] {
        self.axes.map(|axis| axis.dot(x))
    }

    fn vector(&self, [along, across]: [f64; 2]) -> Vector<D> {
        self.axes[0] * along + self.axes[1] * across
    }

    fn matrix(&self, m: [[f64; 2]; 2]) -> SMatrix<f64, D, D> {
        let axes = &self.axes;
        (0..2).fold(SMatrix::zeros(), |sum, i| (0..2).fold(sum, |sum, j| sum + axes[i] * axes[j].transpose() * m[i][j]))
    }
}

/// A point of an ellipse with the half axes a.
#[derive(Clone, Copy, Debug)]
struct Nearest {
    point: [f64; 2],
    /// What it changes by with the point to which it is nearest.
    slope: [[f64; 2]; 2],
    /// What it changes by where all is made larger but that point.
    by_limit: [f64; 2],
    /// Whether it is on the boundary, which of a segment are its ends.
    slides: bool,
}

/// The point that is nearest to `x`; `None` for `x` itself.
fn nearest(a: [f64; 2], x: [f64; 2]) -> Option<Nearest> {
    let reached = |i: usize| if x[i] == 0.0 { 0.0 } else { x[i] / a[i] };
    if reached(0).hypot(reached(1)) <= 1.0 + ROUNDING {
        return None;
    }
    if let Some(free) = (0..2).find(|&i| a[i] == 0.0) {
        return Some(of_segment(1 - free, a, x));
    }
    let normalized = |p: [f64; 2]| p.map(|x| x / p[0].hypot(p[1]));
    let largest = x[0].abs().max(x[1].abs());
    if largest > ENDLESS {
        let finite = x.map(|x| {
            if largest.is_finite() {
                x / largest
            } else if x.is_infinite() {
                x.signum()
            } else {
                0.0
            }
        });
        let p = normalized([a[0] * finite[0], a[1] * finite[1]]);
        let point = [a[0] * p[0], a[1] * p[1]];
        return Some(Nearest { point, slope: [[0.0; 2]; 2], by_limit: point, slides: true });
    }
    let squares = a.map(|a| a * a);
    let (shift, _) = shift_of(a, x);
    let p = normalized(std::array::from_fn(|i| a[i] * x[i] / (squares[i] + shift)));
    let point = [a[0] * p[0], a[1] * p[1]];
    let along = [-a[0] * p[1], a[1] * p[0]];
    let size = p[1] * p[1] * (squares[0] + shift) + p[0] * p[0] * (squares[1] + shift);
    let slope = along.map(|row| along.map(|col| row * col / size));
    // The slope times x, without what cancels in it.
    let turned = p[0] * p[1] * (squares[1] - squares[0]) / size;
    let by_limit = [point[0] - along[0] * turned, point[1] - along[1] * turned];
    Some(Nearest { point, slope, by_limit, slides: true })
}

/// λ of a point outside, and the number of steps that led there.
fn shift_of(a: [f64; 2], x: [f64; 2]) -> (f64, usize) {
    let mut shift = 0.0;
    for step in 0..MOST_STEPS {
        let shifted = a.map(|a| a * a + shift);
        let p: [f64; 2] = std::array::from_fn(|i| a[i] * x[i] / shifted[i]);
        let size = p[0].hypot(p[1]);
        let [p, q] = p.map(|x| x / size);
        let next = shift + (size - 1.0) / (p * p / shifted[0] + q * q / shifted[1]);
        if next <= shift * (1.0 + f64::EPSILON) {
            return (shift, step);
        }
        shift = next;
    }
    (shift, MOST_STEPS)
}

/// The nearest point where there is a limit along one axis only.
fn of_segment(axis: usize, a: [f64; 2], x: [f64; 2]) -> Nearest {
    let (mut point, mut slope, mut by_limit) = ([0.0; 2], [[0.0; 2]; 2], [0.0; 2]);
    let slides = x[axis].abs() > a[axis];
    if slides {
        point[axis] = a[axis].copysign(x[axis]);
        by_limit = point;
    } else {
        point[axis] = x[axis];
        slope[axis][axis] = 1.0;
    }
    Nearest { point, slope, by_limit, slides }
}

#[cfg(test)]
mod tests {
    use super::super::return_mapping::Slider;
    use super::*;
    use fmc_shapes::Splitmix;

    const STIFF: f64 = 100.0;

    fn in_space(x: [f64; 3]) -> Vector<3> {
        Vector::from(x)
    }

    /// A plane and a direction in it that are not those of the axes.
    fn ellipse(factors: [f64; 2]) -> Ellipse<3> {
        let normal = in_space([0.3, -0.5, 0.8]).normalize();
        let along = (in_space([1.0, 0.4, 0.1]) - normal * normal.dot(&in_space([1.0, 0.4, 0.1]))).normalize();
        Ellipse::new(along, &normal, factors)
    }

    fn slider(stick: Stick, limit: f64, factors: [f64; 2]) -> Slider<3> {
        Slider { stick, limit, ellipse: Some(ellipse(factors)) }
    }

    /// Of what is nearest to a point the way there is normal to the ellipse, whatever the sizes; and Newton's method is soon there.
    #[test]
    fn the_nearest_point_has_its_normal_towards_the_other() {
        let mut random = Splitmix::new(3);
        let mut most_steps = 0;
        for _ in 0..200_000 {
            let small = 10f64.powf(random.between(-11.0, 0.0));
            let a = if random.between(0.0, 1.0) < 0.5 { [1.0, small] } else { [small, 1.0] };
            let x: [f64; 2] = std::array::from_fn(|i| {
                let size = 10f64.powf(random.between(-3.0, 9.0)) * a[i];
                if random.between(0.0, 1.0) < 0.5 { size } else { -size }
            });
            let Some(found) = nearest(a, x) else {
                assert!((x[0] / a[0]).hypot(x[1] / a[1]) <= 1.0);
                continue;
            };
            let p: [f64; 2] = std::array::from_fn(|i| found.point[i] / a[i]);
            assert!((p[0].hypot(p[1]) - 1.0).abs() < 1e-14, "{a:?} {x:?}: {found:?}");
            // With the normal p/a: what lies along the tangent (−a₁p₂, a₂p₁) of the way there is none, by all that could.
            let way: [f64; 2] = std::array::from_fn(|i| x[i] - found.point[i]);
            let tangent = [-a[0] * p[1], a[1] * p[0]];
            let sizes: f64 = (0..2).map(|i| (x[i].abs() + found.point[i].abs()) * tangent[i].abs()).sum();
            let along = way[0] * tangent[0] + way[1] * tangent[1];
            assert!(along.abs() < 1e-13 * sizes, "{a:?} {x:?}: {along:e} of {sizes:e}, {found:?}");
            assert!(way[0] * p[0] / a[0] + way[1] * p[1] / a[1] >= 0.0);
            most_steps = most_steps.max(shift_of(a, x).1);
        }
        println!("{most_steps} steps at most");
        assert!(most_steps < 30, "{most_steps}");
    }

    #[test]
    fn with_equal_limits_it_is_the_circle() {
        for factor in [1.0, 0.25] {
            for stick in [Stick::Spring(STIFF), Stick::Memoryless(0.1)] {
                // Without memory the friction acts in full from a slip on that is longer where limits are lower.
                let of_circle =
                    if let Stick::Memoryless(most) = stick { Stick::Memoryless(most / factor) } else { stick };
                let round = Slider { stick: of_circle, limit: 4.0 * factor, ellipse: None };
                for trial in [[0.01, 0.02], [0.07, -0.02], [3.0, 0.1], [-1e3, 2e4]] {
                    let trial = ellipse([1.0; 2]).vector(trial);
                    let (found, wanted) = (slider(stick, 4.0, [factor; 2]).traction(&trial), round.traction(&trial));
                    let close = |x: f64, y: f64| (x - y).abs() <= 1e-13 * (x.abs() + y.abs());
                    assert!((found.value - wanted.value).norm() < 1e-13 * wanted.value.norm(), "{found:?} {wanted:?}");
                    assert!((found.elastic - wanted.elastic).norm() <= 1e-13 * trial.norm());
                    assert!(close(found.stored, wanted.stored) && close(found.dissipated, wanted.dissipated));
                    assert_eq!(found.slides, wanted.slides);
                    assert!((found.by_limit - wanted.by_limit * factor).norm() < 1e-13);
                    let within = SMatrix::<f64, 3, 3>::identity()
                        - in_space([0.3, -0.5, 0.8]).normalize() * in_space([0.3, -0.5, 0.8]).normalize().transpose();
                    let error = within * (found.stiffness - wanted.stiffness) * within;
                    assert!(error.norm() < 1e-13 * wanted.stiffness.norm(), "{error}");
                }
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_traction() {
        let h = 1e-7;
        for stick in [Stick::Spring(STIFF), Stick::Memoryless(0.1)] {
            for factors in [[1.0, 0.4], [0.05, 1.0], [1.0, 0.0], [0.0, 1.0]] {
                let slider = slider(stick, 4.0, factors);
                let ellipse = ellipse(factors);
                for trial in [[0.01, 0.004], [0.07, -0.02], [0.02, 0.05], [0.3, 0.1], [-0.1, 2.0]] {
                    let trial = ellipse.vector(trial);
                    let found = slider.traction(&trial);
                    for axis in ellipse.axes {
                        let rise =
                            slider.traction(&(trial + axis * h)).value - slider.traction(&(trial - axis * h)).value;
                        let error = rise / (2.0 * h) - found.stiffness * axis;
                        assert!(error.norm() < 1e-6 * STIFF, "{stick:?} {factors:?} {trial:?}: {error}");
                    }
                    let [up, down] = [h, -h].map(|h| Slider { limit: 4.0 + h, ..slider }.traction(&trial).value);
                    assert!(
                        ((up - down) / (2.0 * h) - found.by_limit).norm() < 1e-7,
                        "{stick:?} {factors:?} {trial:?}"
                    );
                    let asymmetry = found.stiffness - found.stiffness.transpose();
                    assert!(asymmetry.norm() < 1e-13 * STIFF);
                }
            }
        }
    }

    /// Of all tractions in the ellipse that which is there dissipates most, and energy is stored and lost as is worked.
    #[test]
    fn no_other_traction_dissipates_more() {
        let (limit, mut random) = (4.0, Splitmix::new(9));
        for factors in [[1.0, 0.4], [0.05, 1.0], [1.0, 0.0]] {
            let (slider, ellipse) = (slider(Stick::Spring(STIFF), limit, factors), ellipse(factors));
            for _ in 0..200 {
                let trial = ellipse.vector(std::array::from_fn(|_| random.between(-0.3, 0.3)));
                let found = slider.traction(&trial);
                let slip = trial - found.elastic;
                assert!(found.dissipated >= 0.0 && (found.dissipated - found.value.dot(&slip).max(0.0)).abs() < 1e-15);
                assert!((found.stored - 0.5 * STIFF * found.elastic.norm_squared()).abs() < 1e-15);
                for step in 0..100 {
                    let (sin, cos) = (f64::from(step) * 0.0628).sin_cos();
                    let other = ellipse.vector([factors[0] * cos, factors[1] * sin]) * limit;
                    assert!(other.dot(&slip) < found.dissipated + 1e-14, "{factors:?} {trial}");
                }
            }
        }
    }

    #[test]
    fn sizes_without_bounds_have_an_answer() {
        let flat = ellipse([1.0, 0.4]);
        for (limit, trial) in
            [(1e-300, [1.0, 1.0]), (0.0, [1.0, -2.0]), (1.0, [1e200, 1e-200]), (f64::INFINITY, [1.0, 1.0])]
        {
            let found = slider(Stick::Spring(STIFF), limit, [1.0, 0.4]).traction(&flat.vector(trial));
            let numbers = [found.value, found.elastic, found.by_limit];
            assert!(numbers.iter().all(|x| x.iter().all(|x| x.is_finite())), "{limit}: {found:?}");
            assert!(found.stiffness.iter().all(|x| x.is_finite()) && found.slides != limit.is_infinite());
        }
        // At no limit the slip of equal parts is along (a₁², a₂²).
        let found = slider(Stick::Spring(STIFF), 0.0, [1.0, 0.4]).traction(&flat.vector([1.0, 1.0]));
        let along = flat.vector([1.0, 0.16]) / f64::hypot(1.0, 0.4);
        assert!(found.value.norm() == 0.0 && (found.by_limit - along).norm() < 1e-14, "{found:?}");
        // Nothing holds across: it sticks along.
        let found = slider(Stick::Spring(STIFF), 4.0, [1.0, 0.0]).traction(&flat.vector([0.01, 7.0]));
        // To the digits of k times the slip.
        assert!((found.value - flat.vector([1.0, 0.0])).norm() < 1e-12 && !found.slides && found.dissipated < 1e-12);
    }
}
