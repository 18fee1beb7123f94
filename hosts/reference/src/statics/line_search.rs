//! How far along a step the energy is lowered.

use super::balance::Balance;
use super::equilibrium::Equilibrium;
use super::error::StaticsError;

/// Part of what the slope promises that a step must gain (Armijo).
pub(super) const GAIN: f64 = 1e-4;

/// Part of the energies that a change must exceed to be distinguished from rounding of some thousand pieces of contact.
pub(super) const FLAT: f64 = 1e-12;

/// Trials: 2⁻³⁰ of a step is nothing.
const MOST_TRIALS: usize = 30;

impl<const D: usize> Equilibrium<D> {
    /// State after a part of a step that lowers the energy, and the part; the whole step if it does.
    ///
    /// Where the energy has grown, its slope has changed sign: the next trial is where the slope would vanish if it
    /// were linear, kept away from the ends. Changes as small as rounding do not count.
    pub(super) fn line_search(
        &mut self,
        u: &[[f64; D]],
        balance: &Balance<D>,
        direction: &[[f64; D]],
        load: f64,
    ) -> Result<(Vec<[f64; D]>, Balance<D>, f64), StaticsError> {
        let slope = balance.slope(direction);
        let mut length = 1.0;
        let mut inverted = None;
        for _ in 0..MOST_TRIALS {
            let next = moved(u, direction, length);
            match self.evaluate(&next, load) {
                Ok(reached) => {
                    let promised = balance.energy() + GAIN * length * slope + balance.rounding();
                    // Near the end the energy is flat within rounding; then the forces tell.
                    let flat = FLAT * balance.magnitude() + balance.noise.energy;
                    let is_flat = (reached.energy() - balance.energy()).abs() <= flat;
                    if reached.energy() <= promised || is_flat && reached.norm <= 0.5 * balance.norm {
                        return Ok((next, reached, length));
                    }
                    length = shortened(length, slope, reached.slope(direction));
                    inverted = None;
                }
                Err(error @ StaticsError::Inverted { .. }) => {
                    inverted = Some(error);
                    length *= 0.5;
                }
                Err(error) => return Err(error),
            }
        }
        Err(inverted.unwrap_or(StaticsError::LineSearch { load, residual: balance.relative() }))
    }
}

/// Shorter trial, where the slope would vanish if it were linear between those at the start and at this one.
pub(super) fn shortened(length: f64, slope: f64, there: f64) -> f64 {
    let part = if there > slope { slope / (slope - there) } else { 0.5 };
    length * part.clamp(0.1, 0.7)
}

/// A displacement and a part of a step.
pub(super) fn moved<const D: usize>(u: &[[f64; D]], direction: &[[f64; D]], length: f64) -> Vec<[f64; D]> {
    u.iter().zip(direction).map(|(u, d)| std::array::from_fn(|i| u[i] + length * d[i])).collect()
}
