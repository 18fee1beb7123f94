//! From the slip at a point to its traction.

use super::ellipse::Ellipse;
use super::options::Friction;
use super::traction::{ROUNDING, Stick, Traction};
use crate::geometry::Vector;
use nalgebra::SMatrix;

/// What resists the slip.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slider<const D: usize> {
    pub(crate) stick: Stick,
    /// Traction at which it slides.
    pub(crate) limit: f64,
    /// Where that is not the same in all directions; the limit is then the largest.
    pub(crate) ellipse: Option<Ellipse<D>>,
}

impl Friction {
    /// Traction at which a point under this pressure slides by this coefficient, and what that changes by with the pressure.
    pub(crate) fn limit(&self, pressure: f64, coefficient: f64) -> (f64, f64) {
        // What never slides does not do so whatever the pressure.
        let (pressed, coefficient) = match coefficient.is_infinite() {
            true if pressure > 0.0 => (f64::INFINITY, 0.0),
            true => (self.cohesion, 0.0),
            false => (coefficient * pressure + self.cohesion, coefficient),
        };
        if pressed > self.shear_limit { (self.shear_limit, 0.0) } else { (pressed, coefficient) }
    }
}

impl<const D: usize> Slider<D> {
    /// Traction at this slip: the elastic slip if none of it were plastic; of a slider without memory the slip of the step.
    pub(crate) fn traction(&self, trial: &Vector<D>) -> Traction<D> {
        if let Some(ellipse) = &self.ellipse {
            return ellipse.traction(self.stick, self.limit, trial);
        }
        let size = trial.norm();
        match self.stick {
            Stick::Spring(stiffness) if size * stiffness <= self.limit * (1.0 + ROUNDING) => Traction {
                value: trial * stiffness,
                elastic: *trial,
                slides: false,
                stiffness: SMatrix::identity() * stiffness,
                by_limit: Vector::zeros(),
                stored: 0.5 * stiffness * size * size,
                dissipated: 0.0,
            },
            Stick::Spring(stiffness) => {
                let most = self.limit / stiffness;
                let stored = 0.5 * self.limit * most;
                let dissipated = self.limit * (size - most);
                Traction { elastic: trial * (most / size), stored, dissipated, ..self.at_limit(trial / size, size) }
            }
            Stick::Memoryless(most) if size <= most => {
                let y = size / most;
                // (2 y − y²) ŝ = (2 − y) s/ε, which is smooth at s = 0.
                let along = trial / most;
                let spread = if size > 0.0 { along * along.transpose() * (most / size) } else { SMatrix::zeros() };
                let stiffness = (SMatrix::identity() * (2.0 - y) - spread) * (self.limit / most);
                let by_limit = along * (2.0 - y);
                let value = by_limit * self.limit;
                let dissipated = value.dot(trial);
                Traction {
                    value,
                    elastic: Vector::zeros(),
                    slides: false,
                    stiffness,
                    by_limit,
                    stored: 0.0,
                    dissipated,
                }
            }
            Stick::Memoryless(_) => self.at_limit(trial / size, size),
        }
    }

    /// All of a slip against the limit.
    fn at_limit(&self, along: Vector<D>, size: f64) -> Traction<D> {
        Traction {
            value: along * self.limit,
            elastic: Vector::zeros(),
            slides: true,
            stiffness: (SMatrix::identity() - along * along.transpose()) * (self.limit / size),
            by_limit: along,
            stored: 0.0,
            dissipated: self.limit * size,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sticks_below_the_limit_and_slides_at_it() {
        let limit = Friction::coulomb(0.5).limit(8.0, 0.5).0;
        let slider = Slider { stick: Stick::Spring(100.0), limit, ellipse: None };
        let stuck = slider.traction(&Vector::<2>::new(0.03, 0.0));
        assert_eq!((stuck.value[0], stuck.slides, stuck.dissipated), (3.0, false, 0.0));
        let slid = slider.traction(&Vector::<2>::new(0.0, -0.1));
        assert!((slid.value - Vector::<2>::new(0.0, -4.0)).norm() < 1e-15 && slid.slides);
        // The work of the spring at the limit is stored, that of the slider lost.
        assert!((slid.stored - 0.08).abs() < 1e-15 && (slid.dissipated - 4.0 * 0.06).abs() < 1e-15);
        let limited = Friction { shear_limit: 1.0, cohesion: 0.25, ..Friction::coulomb(0.5) };
        assert_eq!(limited.limit(1.0, 0.5), (0.75, 0.5));
        assert_eq!(limited.limit(9.0, 0.5), (1.0, 0.0));
    }

    #[test]
    fn what_is_at_its_limit_but_for_rounding_sticks() {
        let slider = Slider { stick: Stick::Spring(7.0), limit: 0.3, ellipse: None };
        let slid = slider.traction(&Vector::<3>::new(0.4, -0.2, 0.1));
        for rounding in [-1e-15, 0.0, 1e-15, 1e-12] {
            let again = slider.traction(&(slid.elastic * (1.0 + rounding)));
            assert!(!again.slides && (again.value - slid.value).norm() < 1e-12, "{rounding:e}");
        }
    }

    #[test]
    fn without_memory_the_traction_grows_smoothly_to_the_limit() {
        let slider = Slider { stick: Stick::Memoryless(0.1), limit: 4.0, ellipse: None };
        let at = |x: f64| slider.traction(&Vector::<2>::new(x, 0.0));
        for (slip, traction) in [(0.0, 0.0), (0.05, 3.0), (0.1, 4.0), (-0.3, -4.0)] {
            let found = at(slip);
            assert!((found.value[0] - traction).abs() < 1e-14 && found.elastic.norm() == 0.0);
            assert!((found.dissipated - traction * slip).abs() < 1e-14 && found.stored == 0.0);
        }
    }

    #[test]
    fn derivatives_are_those_of_the_traction() {
        let h = 1e-6;
        for stick in [Stick::Spring(100.0), Stick::Memoryless(0.1)] {
            let slider = Slider { stick, limit: 4.0, ellipse: None };
            for trial in [[0.01, 0.02, -0.005], [0.07, -0.02, 0.05], [0.3, 0.1, -0.2]].map(Vector::<3>::from) {
                let found = slider.traction(&trial);
                for axis in 0..3 {
                    let step = Vector::<3>::ith(axis, h);
                    let rise = slider.traction(&(trial + step)).value - slider.traction(&(trial - step)).value;
                    assert!((rise / (2.0 * h) - found.stiffness.column(axis)).norm() < 1e-5);
                }
                let [up, down] = [h, -h].map(|h| Slider { limit: 4.0 + h, ..slider }.traction(&trial).value);
                assert!(((up - down) / (2.0 * h) - found.by_limit).norm() < 1e-8);
            }
        }
    }
}
