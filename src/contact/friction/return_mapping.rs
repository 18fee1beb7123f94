//! From the slip at a point to its traction.

use super::options::Friction;
use crate::geometry::Vector;

/// A spring with a slider.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slider {
    /// k_T.
    pub(crate) stiffness: f64,
    /// Traction at which it slides.
    pub(crate) limit: f64,
}

/// What a slip leads to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Traction<const D: usize> {
    /// By which side 0 is held back: it acts on side 1.
    pub(crate) value: Vector<D>,
    /// Elastic slip that is left.
    pub(crate) elastic: Vector<D>,
    /// Unit vector of the slip where it slides.
    pub(crate) sliding: Option<Vector<D>>,
    /// Stored energy by area.
    pub(crate) stored: f64,
    /// Dissipated energy by area, never negative.
    pub(crate) dissipated: f64,
}

impl Friction {
    /// Traction at which a point under this pressure slides, and what that changes by with the pressure.
    pub(crate) fn limit(&self, pressure: f64) -> (f64, f64) {
        let pressed = self.coefficient * pressure + self.cohesion;
        if pressed > self.shear_limit { (self.shear_limit, 0.0) } else { (pressed, self.coefficient) }
    }
}

impl Slider {
    /// Traction at this elastic slip, if none of it were plastic.
    pub(crate) fn traction<const D: usize>(&self, trial: &Vector<D>) -> Traction<D> {
        let (size, most) = (trial.norm(), self.limit / self.stiffness);
        if size <= most {
            let stored = 0.5 * self.stiffness * size * size;
            return Traction { value: trial * self.stiffness, elastic: *trial, sliding: None, stored, dissipated: 0.0 };
        }
        let along = trial / size;
        Traction {
            value: along * self.limit,
            elastic: along * most,
            sliding: Some(along),
            stored: 0.5 * self.limit * most,
            dissipated: self.limit * (size - most),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sticks_below_the_limit_and_slides_at_it() {
        let slider = Slider { stiffness: 100.0, limit: Friction::coulomb(0.5).limit(8.0).0 };
        let stuck = slider.traction(&Vector::<2>::new(0.03, 0.0));
        assert_eq!((stuck.value[0], stuck.sliding, stuck.dissipated), (3.0, None, 0.0));
        let slid = slider.traction(&Vector::<2>::new(0.0, -0.1));
        assert!((slid.value - Vector::<2>::new(0.0, -4.0)).norm() < 1e-15 && slid.sliding.is_some());
        // The work of the spring at the limit is stored, that of the slider lost.
        assert!((slid.stored - 0.08).abs() < 1e-15 && (slid.dissipated - 4.0 * 0.06).abs() < 1e-15);
        let limited = Friction { shear_limit: 1.0, cohesion: 0.25, ..Friction::coulomb(0.5) };
        assert_eq!(limited.limit(1.0), (0.75, 0.5));
        assert_eq!(limited.limit(9.0), (1.0, 0.0));
    }
}
