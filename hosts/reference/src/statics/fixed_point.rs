//! The two loops of Wang, Xu and Xue (Algorithm 2).

use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::iteration::{Iteration, Tangent};
use super::report::{Watch, tell};

/// Contact forces of the last iterate are dead loads of the next one.
///
/// ```text
/// outer:  f_internal(ũ) − f − f_contact(u_n) = 0        solved for ũ by Newton's method (inner)
///         u_(n+1) = u_n + relaxation (ũ − u_n)
/// ```
///
/// Supports must hold every body: contact has no stiffness here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedPoint {
    /// Part of a step that is made; 1 is the paper's.
    pub relaxation: f64,
    /// Outer iterations, at most.
    pub most_iterations: usize,
    /// Residual by the forces at which a state counts as balanced.
    pub tolerance: f64,
}

/// How the loop ended.
#[derive(Clone, Debug, PartialEq)]
pub struct FixedPointEnd {
    /// Whether the residual has become small enough.
    pub converged: bool,
    /// Residual by the forces of every iterate.
    pub residuals: Vec<f64>,
    /// Largest contact force on a body, of every iterate.
    pub forces: Vec<f64>,
}

/// Inner iterations of a nonlinear material, at most.
const MOST_INNER: usize = 20;

impl<const D: usize> Equilibrium<D> {
    /// Runs the loop at the full load, from the last equilibrium. Its last iterate is kept, balanced or not.
    ///
    /// # Errors
    /// Those of [`StaticsError`].
    pub fn fixed_point(&mut self, settings: FixedPoint, watch: Watch) -> Result<FixedPointEnd, StaticsError> {
        if self.matrices.equations.has_joined() {
            return Err(fmc_contact::Error::Unsupported { what: "the fixed point of bodies that are joined" }.into());
        }
        let load = 1.0;
        let linear = self.is_linear();
        let mut u = self.displacement.clone();
        self.contact.release_patches();
        let mut factorised = false;
        let mut end = FixedPointEnd { converged: false, residuals: Vec::new(), forces: Vec::new() };
        for iteration in 0..=settings.most_iterations {
            let balance = self.evaluate(&u, load)?;
            let size = |force: &[f64; D]| force.iter().map(|f| f * f).sum::<f64>().sqrt();
            // Before the supports are where they should be, nothing is balanced.
            let residual = if iteration == 0 { 1.0 } else { balance.relative() };
            end.residuals.push(residual);
            end.forces.push(balance.contact.bodies.iter().map(|body| size(&body.force)).fold(0.0, f64::max));
            end.converged = residual <= settings.tolerance;
            let told = Iteration {
                residual,
                tangent: Some(Tangent::Elastic),
                length: settings.relaxation,
                ..Iteration::at(&balance, load, iteration)
            };
            tell(&told, watch)?;
            let touch = balance.contact.forces.clone();
            let last = end.converged || iteration == settings.most_iterations;
            let target = if last { None } else { Some(self.with_dead_contact(&u, &touch, linear, &mut factorised)?) };
            match target {
                None => {
                    self.accept(u, balance, load);
                    break;
                }
                Some(target) => {
                    let part = if iteration == 0 { 1.0 } else { settings.relaxation };
                    u.iter_mut().zip(target).for_each(|(u, t)| (0..D).for_each(|i| u[i] += part * (t[i] - u[i])));
                }
            }
        }
        Ok(end)
    }

    /// Equilibrium under contact forces that do not change.
    fn with_dead_contact(
        &mut self,
        start: &[[f64; D]],
        touch: &[[f64; D]],
        linear: bool,
        factorised: &mut bool,
    ) -> Result<Vec<[f64; D]>, StaticsError> {
        let mut u = start.to_vec();
        self.prescribe(&mut u, 1.0);
        let mut first = None;
        for _ in 0..if linear { 1 } else { MOST_INNER } {
            let mut residual = vec![[0.0; D]; u.len()];
            self.problem.model.internal(&u, &mut residual);
            for (node, r) in residual.iter_mut().enumerate() {
                (0..D).for_each(|i| r[i] -= touch[node][i] + self.problem.load[node][i]);
            }
            let right = residual.as_flattened().iter().map(|r| -r).collect::<Vec<f64>>();
            let right = self.matrices.equations.gathered(&right);
            let size = right.iter().map(|r| r * r).sum::<f64>().sqrt();
            if size <= 1e-10 * *first.get_or_insert(size) {
                break;
            }
            if !(linear && *factorised) {
                self.linearised_at = u.as_flattened().to_vec();
                let elastic = self.elastic();
                *factorised = self.matrices.factorise_bodies(&elastic);
            }
            let step = self.matrices.system.solve(&right).filter(|step| {
                let longest = step.iter().fold(0.0, |most: f64, d| most.max(d.abs()));
                longest < 1e6 * self.size()
            });
            let Some(step) = step else {
                return Err(self.unheld());
            };
            self.iterations += 1;
            let step = self.matrices.equations.spread(&step);
            u.as_flattened_mut().iter_mut().zip(step).for_each(|(u, d)| *u += d);
        }
        Ok(u)
    }

    /// Why the bodies alone have no factors: nothing holds the one at which they end, or else they buckle.
    fn unheld(&self) -> StaticsError {
        let Some(equation) = self.matrices.system.failed_at() else { return StaticsError::Unstable { load: 1.0 } };
        let node = self.matrices.equations.freedom(equation) / D;
        let parts = self.problem.model.parts().iter().enumerate();
        let body = parts.filter(|(part, _)| self.problem.model.nodes_of(*part).contains(&node));
        let body = body.map(|(_, part)| part.name.clone()).collect();
        StaticsError::Unsupported { body, motion: "rigid motion".to_owned() }
    }
}
