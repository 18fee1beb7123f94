//! Newton's method for friction whose limit follows the pressure: an unsymmetric matrix, and no energy.

use super::balance::Balance;
use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::iteration::{Iteration, Tangent};
use super::line_search::moved;
use super::newton::{State, Watch};
use super::newton_settings::NewtonSettings;
use fmc_contact::sparse::{Entries, solve_unsymmetric};

/// Trials along a step: one that is still no better at 2⁻⁸ of it leads nowhere.
const MOST_TRIALS: usize = 9;

impl<const D: usize> Equilibrium<D> {
    /// Equilibrium with the pressure of every iterate; steps are shortened until the residual falls.
    pub(super) fn with_current_pressure(
        &mut self,
        start: Vec<[f64; D]>,
        load: f64,
        watch: Watch,
    ) -> Result<State<D>, StaticsError> {
        let NewtonSettings { tolerance, most_iterations, full_below, .. } = self.settings;
        self.keep_patches(&start)?;
        let (mut u, mut balance) = (start.clone(), self.evaluate(&start, load)?);
        let mut turned = !self.problem.contact.law.is_fiber();
        for iteration in 0..=most_iterations {
            if !turned && balance.relative() <= full_below {
                self.keep_patches(&u)?;
                balance = self.evaluate(&u, load)?;
                turned = true;
            }
            let residual = balance.relative();
            let mut told = Iteration::at(&balance, load, iteration);
            if residual <= tolerance {
                return self.tell(&told, watch).map(|()| (u, balance));
            }
            if iteration == most_iterations {
                break;
            }
            let step = self.unsymmetric_step(&u, &balance)?.ok_or(StaticsError::Unstable { load })?;
            self.iterations += 1;
            let (next, reached, length) = match self.least_residual(&u, &balance, &self.on_nodes(&step), load) {
                Err(StaticsError::LineSearch { .. }) if residual <= 1e3 * tolerance => return Ok((u, balance)),
                searched => searched?,
            };
            (told.tangent, told.length) = (Some(Tangent::Full), length);
            self.tell(&told, watch)?;
            (u, balance) = (next, reached);
        }
        let residual = balance.relative();
        Err(StaticsError::NotConverged { load, iterations: most_iterations, residual })
    }

    /// Newton step with the whole matrix: where contact acts on few equations, on the factors of the bodies down to these.
    fn unsymmetric_step(&mut self, u: &[[f64; D]], balance: &Balance<D>) -> Result<Option<Vec<f64>>, StaticsError> {
        let right: Vec<f64> = self.on_equations(&balance.residual).iter().map(|r| -r).collect();
        let (elastic, touching) = (self.elastic(u), self.touching_whole(u)?);
        let ground: Entries = touching.iter().copied().filter(|(row, column, _)| row >= column).collect();
        if !touching.is_empty() && self.condense(u, &elastic, &ground, &balance.contact.forces) {
            let stood_on = self.ground.iter().flat_map(|&(row, column, value)| {
                [(row, column, -value), (column, row, -value)].into_iter().take(if row == column { 1 } else { 2 })
            });
            let change = self.kept.placed(&touching.iter().copied().chain(stood_on).collect());
            if let (Some(change), Some(condensed)) = (change, self.bulk.condense(&right))
                && let Some(kept) = self.bulk.schur().solve_changed_unsymmetric(&change, &condensed.kept)
                && let Some(step) = self.bulk.follow(condensed.inner.iter().copied(), &kept)
            {
                return Ok(Some(step));
            }
        }
        Ok(solve_unsymmetric(&elastic, &touching, &right))
    }

    /// State after a part of a step that lowers the residual, and the part.
    fn least_residual(
        &mut self,
        u: &[[f64; D]],
        balance: &Balance<D>,
        direction: &[[f64; D]],
        load: f64,
    ) -> Result<(Vec<[f64; D]>, Balance<D>, f64), StaticsError> {
        let mut length = 1.0;
        let mut inverted = None;
        for _ in 0..MOST_TRIALS {
            let next = moved(u, direction, length);
            match self.evaluate(&next, load) {
                Ok(reached) if balance.descent().is_weakened_by(length, &reached.descent()) => {
                    return Ok((next, reached, length));
                }
                Ok(_) => inverted = None,
                Err(error @ StaticsError::Inverted { .. }) => inverted = Some(error),
                Err(error) => return Err(error),
            }
            length *= 0.5;
        }
        Err(inverted.unwrap_or(StaticsError::LineSearch { load, residual: balance.relative() }))
    }
}
