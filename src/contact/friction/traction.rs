//! A traction, and the stick from which it comes.

use crate::geometry::Vector;
use nalgebra::SMatrix;

/// Part of the limit by which a traction may exceed it and still sticks. What slid is at its limit where the next step begins: rounding would
/// decide whether the first tangent of that step is one of stick or of slip.
pub(super) const ROUNDING: f64 = 1e-10;

/// What resists the slip below the limit.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Stick {
    /// A spring with memory, of stiffness k_T.
    Spring(f64),
    /// Nothing that remembers: the traction grows with the slip of the step up to this slip.
    Memoryless(f64),
}

/// What a slip leads to.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Traction<const D: usize> {
    /// By which side 0 is held back: it acts on side 1.
    pub(crate) value: Vector<D>,
    /// Elastic slip that is left.
    pub(crate) elastic: Vector<D>,
    /// Whether it slides at the limit.
    pub(crate) slides: bool,
    /// Derivative of the traction by the slip.
    pub(crate) stiffness: SMatrix<f64, D, D>,
    /// And by the limit.
    pub(crate) by_limit: Vector<D>,
    /// Stored energy by area.
    pub(crate) stored: f64,
    /// Dissipated energy by area, never negative.
    pub(crate) dissipated: f64,
}

impl<const D: usize> Traction<D> {
    /// The stiffness with that along the slip from none to this one: where it slides nothing resists more of it, and a quadratic energy that
    /// has this stiffness is nowhere below that of the slider.
    pub(super) fn secant(&self, trial: &Vector<D>, dual: &Vector<D>) -> SMatrix<f64, D, D> {
        let work = self.value.dot(trial);
        match self.slides && work > 0.0 {
            true => {
                let part = 1.0 - dual.dot(&self.value) / self.value.norm();
                self.stiffness + self.value * self.value.transpose() * (part / work)
            }
            false => self.stiffness,
        }
    }
}
