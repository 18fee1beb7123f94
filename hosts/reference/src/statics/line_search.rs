//! How far along a step the energy is lowered.

use super::balance::Balance;
use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use fmc_contact::contact::equilibrium::descent::shortened;

/// Trials: 2⁻³⁰ of a step is nothing.
const MOST_TRIALS: usize = 30;

impl<const D: usize> Equilibrium<D> {
    /// State after a part of a step that lowers the energy, and the part; the whole step if it does.
    ///
    /// By the rules of [`fmc_contact::contact::equilibrium::descent`].
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
                    if balance.descent().is_lowered_by(length, slope, &reached.descent()) {
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

/// A displacement and a part of a step.
pub(super) fn moved<const D: usize>(u: &[[f64; D]], direction: &[[f64; D]], length: f64) -> Vec<[f64; D]> {
    u.iter().zip(direction).map(|(u, d)| std::array::from_fn(|i| u[i] + length * d[i])).collect()
}
