//! Steps for which the bodies are linear and the contact is as it is.

use super::balance::Balance;
use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::iteration::Tangent;
use super::line_search::{FLAT, GAIN, shortened};
use crate::sparse::Condensed;
use fmc_contact::ContactForces;

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

/// Least energy over steps d, with r the residual of the bodies and K their stiffness at u:
/// r·d + ½ d·K d + contact energy(u + d).
///
/// With b = −r condensed to b̂ on the kept equations, and the others in the part s of their way to balance,
///
/// ```text
/// energy = ½ d·S d − b̂·d − (s − ½ s²) |L⁻¹ b|² + contact      d, S on the kept equations; |…| over the others
/// ```
struct Model<'a, const D: usize> {
    u: &'a [[f64; D]],
    condensed: Condensed,
    /// b̂ − b on the kept equations.
    change: Vec<f64>,
    /// |L⁻¹ b|² and |b|² of the others.
    inner: [f64; 2],
    scale: f64,
    /// Magnitude of the energies, for rounding.
    magnitude: f64,
}

/// A step and its place in the model.
struct At {
    kept: Vec<f64>,
    /// s.
    part: f64,
    /// S d.
    pull: Vec<f64>,
    energy: f64,
    /// Derivative of the energy by d.
    gradient: Vec<f64>,
    /// Of the residual on all equations.
    norm: f64,
    step: Vec<f64>,
}

/// Where to go from there: d, and S d.
struct Direction {
    kept: Vec<f64>,
    pull: Vec<f64>,
    tangent: Tangent,
}

impl<const D: usize> Model<'_, D> {
    /// Derivative of the energy along a direction from `from`, at `at`.
    fn slope(&self, from: &At, direction: &Direction, at: &At) -> f64 {
        dot(&at.gradient, &direction.kept) - (1.0 - from.part) * (1.0 - at.part) * self.inner[0]
    }
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
        let (mut iterations, mut full_failed) = (0, false);
        while at.norm > goal && iterations < MOST_ITERATIONS {
            let is_far = at.norm > self.settings.full_below * model.scale;
            let wish = if is_far || full_failed { Tangent::Semidefinite } else { Tangent::Full };
            let Some(direction) = self.contact_direction(&model, &at, wish)? else { break };
            let Some(next) = self.search_in(&model, &at, &direction)? else {
                // The semidefinite tangent has not been tried here.
                if direction.tangent == Tangent::Full {
                    full_failed = true;
                    continue;
                }
                break;
            };
            full_failed = direction.tangent == Tangent::Full && next.norm > 0.5 * at.norm;
            at = next;
            iterations += 1;
        }
        self.contact_iterations += iterations;
        let inner = model.condensed.inner.iter().map(|y| at.part * y);
        let Some(step) = self.bulk.follow(inner, &at.kept) else { return Ok(None) };
        let direction = self.on_nodes(&step);
        Ok((balance.slope(&direction) < 0.0).then_some(ContactStep { direction, iterations }))
    }

    fn contact_model<'a>(&self, u: &'a [[f64; D]], balance: &Balance<D>) -> Option<Model<'a, D>> {
        let touch = self.on_equations(&balance.contact.forces);
        let right: Vec<f64> = self.on_equations(&balance.residual).iter().zip(&touch).map(|(r, f)| -r - f).collect();
        let condensed = self.bulk.condense(&right)?;
        let own = self.kept.of(&right);
        let change = condensed.kept.iter().zip(&own).map(|(condensed, own)| condensed - own).collect();
        let others = right.iter().enumerate().filter(|(equation, _)| self.kept.place(*equation).is_none());
        let inner = [dot(&condensed.inner, &condensed.inner), others.map(|(_, b)| b * b).sum()];
        Some(Model { u, condensed, change, inner, scale: balance.scale, magnitude: balance.magnitude() })
    }

    /// Place of a step: of the kept equations, the part of the others' way, and the step on all; and S times the first.
    fn at(
        &self,
        model: &Model<D>,
        (kept, part, step): (Vec<f64>, f64, Vec<f64>),
        pull: Vec<f64>,
        touch: &ContactForces<D>,
    ) -> At {
        let Model { condensed, change, inner, .. } = model;
        let forces = self.on_equations(&touch.forces);
        let outside = forces.iter().enumerate().filter(|(equation, _)| self.kept.place(*equation).is_none());
        let outside: f64 = outside.map(|(_, f)| f * f).sum();
        let forces = self.kept.of(&forces);
        let gradient: Vec<f64> = (0..kept.len()).map(|k| pull[k] - condensed.kept[k] - forces[k]).collect();
        let residual: f64 = gradient.iter().zip(change).map(|(g, c)| (g + (1.0 - part) * c).powi(2)).sum();
        let norm = (residual + (1.0 - part).powi(2) * inner[1] + outside).sqrt();
        let bodies = 0.5 * dot(&pull, &kept) - dot(&condensed.kept, &kept) - (part - 0.5 * part * part) * inner[0];
        let energy = bodies + touch.energy + touch.friction.stored + touch.friction.dissipated;
        At { kept, part, pull, energy, gradient, norm, step }
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
            let entries = self.touching(&place, tangent)?;
            let ground = self.ground.iter().map(|(row, column, value)| (*row, *column, -value));
            let Some(change) = self.kept.placed(entries.into_iter().chain(ground)) else { return Ok(None) };
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
        for (row, column, value) in self.kept.placed(self.ground.iter().copied()).into_iter().flatten() {
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
                    let is_flat = (next.energy - at.energy).abs() <= FLAT * model.magnitude;
                    if next.energy <= at.energy + GAIN * length * slope || is_flat && next.norm <= 0.5 * at.norm {
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

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}
