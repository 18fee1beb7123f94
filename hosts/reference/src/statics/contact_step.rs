//! Steps for which the bodies are linear and the contact is as it is.

use super::balance::Balance;
use super::contact_model::{At, Direction, Model};
use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::iteration::Tangent;
use fmc_contact::ContactForces;
use fmc_contact::contact::equilibrium::descent::{TangentChoice, shortened};

/// Iterations of the contact, at most.
const MOST_ITERATIONS: usize = 80;

/// Part of the residual that may be left where the bodies are not linear; less near the end, which stays quadratic.
const LEFT_OVER: f64 = 1e-2;

/// Trials along a direction.
const MOST_TRIALS: usize = 12;

type Touch<const D: usize> = Result<ContactForces<D>, fmc_contact::Error>;

/// A step, and what finding it took.
pub(super) struct ContactStep<const D: usize> {
    pub(super) direction: Vec<[f64; D]>,
    /// Iterations of the contact.
    pub(super) iterations: usize,
}

impl<const D: usize> Equilibrium<D> {
    /// Step to the equilibrium of the contact with the bodies linearised at u.
    ///
    /// Contact acts on few nodes, and opens and closes; the bodies are many equations, and nearly linear. So the bodies
    /// are factorised once, down to the equations on which contact acts, and what is iterated is dense and small.
    /// `None` where contact acts on nothing or on too much, or the bodies alone are not stable.
    pub(super) fn contact_step(
        &mut self,
        u: &[[f64; D]],
        balance: &Balance<D>,
    ) -> Result<Option<ContactStep<D>>, StaticsError> {
        let first = self.touching(u, Tangent::Semidefinite)?;
        if first.is_empty() {
            return Ok(None);
        }
        let stiffness = self.elastic(u);
        if !self.condense(u, &stiffness, &first, &balance.contact.forces) {
            return Ok(None);
        }
        let Some(model) = self.contact_model(u, balance) else { return Ok(None) };
        let count = self.kept.equations().len();
        let [none, step] = [count, self.equation_count].map(|size| vec![0.0; size]);
        let mut at = self.at(&model, (none.clone(), 0.0, step), none, &balance.contact);
        let exact = 0.1 * self.settings.tolerance * balance.scale;
        let goal = if self.is_linear() { exact } else { exact.max(LEFT_OVER.min(balance.relative()) * balance.norm) };
        let (mut iterations, mut choice) = (0, TangentChoice::default());
        while at.norm > goal && iterations < MOST_ITERATIONS {
            let wish = choice.wish(at.norm, self.settings.full_below, model.scale).into();
            let Some(direction) = self.contact_direction(&model, &at, wish)? else { break };
            let next = self.search_in(&model, &at, &direction)?;
            let reached = next.as_ref().map(|next| next.descent(&model));
            choice.made(direction.tangent.part(), &at.descent(&model), reached.as_ref());
            match next {
                Some(next) => at = next,
                // The semidefinite tangent has not been tried here.
                None if direction.tangent == Tangent::Full => continue,
                None => break,
            }
            iterations += 1;
        }
        self.contact_iterations += iterations;
        let inner = model.condensed.inner.iter().map(|y| at.part * y);
        let Some(step) = self.bulk.follow(inner, &at.kept) else { return Ok(None) };
        let direction = self.on_nodes(&step);
        Ok((balance.slope(&direction) < 0.0).then_some(ContactStep { direction, iterations }))
    }

    /// Newton step in the model with the contact's stiffness; `None` if contact acts where it did not, or there is none.
    fn contact_direction(
        &mut self,
        model: &Model<D>,
        at: &At,
        wish: Tangent,
    ) -> Result<Option<Direction>, StaticsError> {
        let right: Vec<f64> = at.gradient.iter().map(|g| -g).collect();
        let place = self.stepped(model.u, &at.step);
        for tangent in [wish, Tangent::Semidefinite] {
            let mut entries = self.touching(&place, tangent)?;
            entries.extend(self.ground.iter().map(|(row, column, value)| (*row, *column, -value)));
            let Some(change) = self.kept.placed(&entries) else { return Ok(None) };
            let Some(kept) = self.bulk.schur().solve_changed(&change, &right) else { continue };
            let pull = self.pull(&kept);
            let direction = Direction { kept, pull, tangent };
            if model.slope(at, &direction, at) < 0.0 {
                return Ok(Some(direction));
            }
        }
        Ok(None)
    }

    /// Force of the bodies condensed on the kept equations, for a step of these.
    fn pull(&mut self, kept: &[f64]) -> Vec<f64> {
        let mut pull = self.bulk.schur().times(kept);
        for (row, column, value) in self.kept.placed(&self.ground).into_iter().flatten() {
            pull[row] -= value * kept[column];
            if row != column {
                pull[column] -= value * kept[row];
            }
        }
        pull
    }

    /// Place along a direction at which the model's energy is lower; `None` if there is none.
    fn search_in(&mut self, model: &Model<D>, at: &At, direction: &Direction) -> Result<Option<At>, StaticsError> {
        let slope = model.slope(at, direction, at);
        let mut length = 1.0;
        for _ in 0..MOST_TRIALS {
            let along = |from: &[f64], by: &[f64]| -> Vec<f64> {
                from.iter().zip(by).map(|(from, by)| from + length * by).collect()
            };
            let (kept, pull) = (along(&at.kept, &direction.kept), along(&at.pull, &direction.pull));
            let part = at.part + length * (1.0 - at.part);
            let Some((step, touch)) = self.followed(model, at, &kept, part) else { return Ok(None) };
            match touch {
                Ok(touch) => {
                    let next = self.at(model, (kept, part, step), pull, &touch);
                    if at.descent(model).is_lowered_by(length, slope, &next.descent(model)) {
                        return Ok(Some(next));
                    }
                    length = shortened(length, slope, model.slope(at, direction, &next));
                }
                Err(fmc_contact::Error::InvertedCell { .. } | fmc_contact::Error::FoldedCell { .. }) => length *= 0.5,
                Err(error) => return Err(error.into()),
            }
        }
        Ok(None)
    }

    /// The step on all equations and the contact there. After the first iteration only what is near the kept equations follows
    /// them; what is far away does so where that would turn cells inside out.
    fn followed(&mut self, model: &Model<D>, at: &At, kept: &[f64], part: f64) -> Option<(Vec<f64>, Touch<D>)> {
        let inner = || model.condensed.inner.iter().map(|y| part * y);
        if at.part > 0.0 {
            let mut step = at.step.clone();
            self.bulk.follow_near(inner(), kept, &mut step)?;
            let touch = self.touch_at(&self.stepped(model.u, &step));
            if touch.is_ok() {
                return Some((step, touch));
            }
        }
        let step = self.bulk.follow(inner(), kept)?;
        let touch = self.touch_at(&self.stepped(model.u, &step));
        Some((step, touch))
    }

    fn stepped(&self, u: &[[f64; D]], step: &[f64]) -> Vec<[f64; D]> {
        let step = self.on_nodes(step);
        u.iter().zip(step).map(|(u, d)| std::array::from_fn(|i| u[i] + d[i])).collect()
    }
}
