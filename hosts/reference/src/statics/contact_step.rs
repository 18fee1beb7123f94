//! Steps for which the bodies are linear and the contact is as it is.

use super::balance::Balance;
use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::iteration::Tangent;
use super::line_search::{FLAT, GAIN, shortened};
use crate::sparse::{Entries, Lower};

/// Equations on which contact acts, at most: the systems of the iterations have no more, but are dense. With more, the iterations
/// are fewer still, and no faster: `hertz3d` with 2 315 kept of 19 398 takes 4 for 7, with 4 719 of 72 751 5 for 15, in the same
/// time and up to 2.7 times the memory.
const MOST_KEPT: usize = 1500;

/// Iterations of the contact, at most.
const MOST_ITERATIONS: usize = 80;

/// Part of the residual that may be left where the bodies are not linear; less near the end, which stays quadratic.
const LEFT_OVER: f64 = 1e-2;

/// Trials along a direction.
const MOST_TRIALS: usize = 12;

/// A step, and what finding it took.
pub(super) struct ContactStep<const D: usize> {
    pub(super) direction: Vec<[f64; D]>,
    /// Iterations of the contact.
    pub(super) iterations: usize,
}

/// Least energy over steps d, with r the residual of the bodies and K their stiffness at u:
/// r·d + ½ d·K d + contact energy(u + d).
struct Model<'a, const D: usize> {
    u: &'a [[f64; D]],
    residual: Vec<f64>,
    stiffness: &'a Lower,
    scale: f64,
    /// Magnitude of the energies, for rounding.
    magnitude: f64,
}

/// A step and its place in the model.
#[derive(Clone)]
struct At {
    step: Vec<f64>,
    /// K d.
    pull: Vec<f64>,
    energy: f64,
    gradient: Vec<f64>,
}

impl At {
    fn norm(&self) -> f64 {
        dot(&self.gradient, &self.gradient).sqrt()
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
        if !self.condense(u, &stiffness, &first) {
            return Ok(None);
        }
        let touch = self.on_equations(&balance.contact.forces);
        let gradient = self.on_equations(&balance.residual);
        let model = Model {
            u,
            residual: gradient.iter().zip(&touch).map(|(g, f)| g + f).collect(),
            stiffness: &stiffness,
            scale: balance.scale,
            magnitude: balance.magnitude(),
        };
        let none = vec![0.0; self.equation_count];
        let mut at =
            At { step: none.clone(), pull: none, energy: balance.contact_energy + balance.friction_energy, gradient };
        let exact = 0.1 * self.settings.tolerance * balance.scale;
        let goal = if self.is_linear() { exact } else { exact.max(LEFT_OVER.min(balance.relative()) * balance.norm) };
        let (mut iterations, mut full_failed) = (0, false);
        while at.norm() > goal && iterations < MOST_ITERATIONS {
            let is_far = at.norm() > self.settings.full_below * model.scale;
            let wish = if is_far || full_failed { Tangent::Semidefinite } else { Tangent::Full };
            let Some((direction, tangent)) = self.contact_direction(&model, &at, wish)? else { break };
            let Some(next) = self.search_in(&model, &at, &direction)? else { break };
            full_failed = tangent == Tangent::Full && next.norm() > 0.5 * at.norm();
            at = next;
            iterations += 1;
        }
        self.contact_iterations += iterations;
        let direction = self.on_nodes(&at.step);
        Ok((balance.slope(&direction) < 0.0).then_some(ContactStep { direction, iterations }))
    }

    /// Factorises the bodies down to the equations of some entries, if that is of use.
    pub(super) fn condense(&mut self, u: &[[f64; D]], elastic: &Lower, entries: &Entries) -> bool {
        let mut kept: Vec<usize> = entries.iter().flat_map(|(row, column, _)| [*row, *column]).collect();
        sort(&mut kept);
        if kept.len() > MOST_KEPT {
            return false;
        }
        // Factors of linear bodies hold wherever contact acts on what they have kept, and keep more and more as it moves.
        if self.is_linear() && self.ground.is_empty() && !self.kept.is_empty() {
            if kept.iter().all(|equation| self.kept.binary_search(equation).is_ok()) {
                return true;
            }
            if kept.len() + self.kept.len() <= MOST_KEPT {
                kept.extend(&self.kept);
                sort(&mut kept);
            }
        }
        // Bodies that only contact holds stand on that of now.
        self.ground = if self.free_motions(u).is_empty() { Vec::new() } else { entries.clone() };
        self.kept = kept;
        let done = if self.ground.is_empty() {
            self.bulk.factorise(elastic, &self.kept)
        } else {
            let whole = elastic.entries().chain(self.ground.iter().copied());
            self.bulk.factorise(&Lower::new(self.equation_count, whole), &self.kept)
        };
        if !done {
            self.kept.clear();
        }
        done
    }

    /// Newton step in the model with the contact's stiffness; `None` if contact acts where it did not, or there is none.
    fn contact_direction(
        &mut self,
        model: &Model<D>,
        at: &At,
        wish: Tangent,
    ) -> Result<Option<(Vec<f64>, Tangent)>, StaticsError> {
        let right: Vec<f64> = at.gradient.iter().map(|g| -g).collect();
        let place = self.stepped(model.u, &at.step);
        for tangent in [wish, Tangent::Semidefinite] {
            let mut entries = self.touching(&place, tangent)?;
            entries.extend(self.ground.iter().map(|(row, column, value)| (*row, *column, -value)));
            let local = |equation: usize| self.kept.binary_search(&equation).ok();
            let change: Option<Entries> =
                entries.into_iter().map(|(row, column, value)| Some((local(row)?, local(column)?, value))).collect();
            let Some(change) = change else { return Ok(None) };
            if let Some(direction) = self.bulk.solve_changed(&change, &right)
                && dot(&at.gradient, &direction) < 0.0
            {
                return Ok(Some((direction, tangent)));
            }
        }
        Ok(None)
    }

    /// Place along a direction at which the model's energy is lower; `None` if there is none.
    fn search_in(&mut self, model: &Model<D>, at: &At, direction: &[f64]) -> Result<Option<At>, StaticsError> {
        let slope = dot(&at.gradient, direction);
        let pull = model.stiffness.product(direction);
        let mut length = 1.0;
        for _ in 0..MOST_TRIALS {
            let along = |from: &[f64], by: &[f64]| -> Vec<f64> {
                from.iter().zip(by).map(|(from, by)| from + length * by).collect()
            };
            let (step, pull) = (along(&at.step, direction), along(&at.pull, &pull));
            let place = self.stepped(model.u, &step);
            match self.touch_at(&place) {
                Ok(touch) => {
                    let friction = touch.friction.stored + touch.friction.dissipated;
                    let energy = dot(&model.residual, &step) + 0.5 * dot(&step, &pull) + touch.energy + friction;
                    let forces = self.on_equations(&touch.forces);
                    let gradient = (0..step.len()).map(|k| model.residual[k] + pull[k] - forces[k]).collect();
                    let next = At { step, pull, energy, gradient };
                    let is_flat = (next.energy - at.energy).abs() <= FLAT * model.magnitude;
                    if next.energy <= at.energy + GAIN * length * slope || is_flat && next.norm() <= 0.5 * at.norm() {
                        return Ok(Some(next));
                    }
                    length = shortened(length, slope, dot(&next.gradient, direction));
                }
                Err(fmc_contact::Error::InvertedCell { .. } | fmc_contact::Error::FoldedCell { .. }) => length *= 0.5,
                Err(error) => return Err(error.into()),
            }
        }
        Ok(None)
    }

    fn stepped(&self, u: &[[f64; D]], step: &[f64]) -> Vec<[f64; D]> {
        let step = self.on_nodes(step);
        u.iter().zip(step).map(|(u, d)| std::array::from_fn(|i| u[i] + d[i])).collect()
    }
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

/// Ascending, none twice.
fn sort(equations: &mut Vec<usize>) {
    equations.sort_unstable();
    equations.dedup();
}
