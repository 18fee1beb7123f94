//! A displacement and its place in the model.

use super::bodies::Checked;
use super::options::ContactStepOptions;
use super::touching::{ROUNDING, Touch, Touching};
use crate::Error;
use crate::contact::equilibrium::descent::{Descent, shortened};
use nalgebra::DVector;

#[derive(Clone, Debug)]
pub(super) struct Iterate {
    pub(super) displacement: DVector<f64>,
    pub(super) touch: Touch,
    /// Energy of the model.
    energy: f64,
    /// Change of it that is not to be distinguished from rounding.
    flat: f64,
    /// S d + r − f.
    pub(super) residual: DVector<f64>,
}

impl Iterate {
    pub(super) fn new(bodies: &Checked, contact: &mut dyn Touching, displacement: DVector<f64>) -> Result<Self, Error> {
        let touch = contact.at(&displacement)?;
        let residual = &bodies.stiffness * &displacement + &bodies.residual - &touch.forces;
        let (work, strain) =
            (bodies.residual.dot(&displacement), 0.5 * displacement.dot(&(&bodies.symmetric * &displacement)));
        let energy = work + strain + touch.energy;
        let magnitude = work.abs() + strain.abs() + touch.energy.abs();
        // Coordinates are known to a bit, and the energy to the work of the forces along it.
        let coords = (0..bodies.count()).map(|place| contact.start(place).abs() + displacement[place].abs());
        let known: f64 = touch.forces.iter().zip(coords).map(|(force, x)| force.abs() * x).sum();
        let flat = Descent::flatness(magnitude) + ROUNDING * known;
        if !energy.is_finite() {
            return Err(Error::Overflow { quantity: "energy of a contact step", value: energy });
        }
        // Entries may be finite whose norm is not, and what is compared with an infinite one has always converged.
        let norms = residual.norm() + bodies.residual.norm() + touch.forces.norm();
        if !norms.is_finite() {
            return Err(Error::Overflow { quantity: "residual of a contact step", value: norms });
        }
        Ok(Self { displacement, touch, energy, flat, residual })
    }

    pub(super) fn norm(&self) -> f64 {
        self.residual.norm()
    }

    pub(super) fn descent(&self) -> Descent {
        Descent { energy: self.energy, norm: self.norm(), rounding: 0.0, flat: self.flat }
    }

    /// The iterate after a part of a direction: one that lowers the energy, or, where there is none, the residual.
    /// Also the number of trials.
    pub(super) fn after(
        &self,
        bodies: &Checked,
        contact: &mut dyn Touching,
        direction: &DVector<f64>,
        options: &ContactStepOptions,
        has_energy: bool,
    ) -> Result<(Option<Self>, usize), Error> {
        let slope = self.residual.dot(direction);
        let mut length = 1.0;
        for trial in 1..=options.max_trials {
            match Self::new(bodies, contact, &self.displacement + direction * length) {
                Ok(next) => {
                    let (from, to) = (self.descent(), next.descent());
                    let is_lower = match has_energy {
                        true => from.is_lowered_by(length, slope, &to),
                        false => from.is_weakened_by(length, &to),
                    };
                    if is_lower {
                        return Ok((Some(next), trial));
                    }
                    length = match has_energy {
                        true => shortened(length, slope, next.residual.dot(direction)),
                        false => 0.5 * length,
                    };
                }
                Err(Error::InvertedCell { .. } | Error::FoldedCell { .. }) => length *= 0.5,
                Err(error) => return Err(error),
            }
        }
        Ok((None, options.max_trials))
    }
}
