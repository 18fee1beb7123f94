//! What a step is asked for, and what is said of it.

use crate::Error;

/// When a step ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactStepOptions {
    /// Residual, by the larger of the norms of the residual given and of the contact forces, at which a step has converged.
    pub tolerance: f64,
    /// Residual, a force, at which it has converged too; 0: none. Bodies that are not linear need no more than a part of what
    /// their linearisation leaves.
    pub absolute_tolerance: f64,
    /// Relative residual below which the full tangent is taken.
    pub full_below: f64,
    /// Iterations, at most.
    pub max_iterations: usize,
    /// Trials along a direction, at most.
    pub max_trials: usize,
    /// Whether softer contacts come first where the first step of Newton's method cannot be taken whole: where it would not lower
    /// the energy (without an energy, the residual), or would turn a cell inside out. The contact is then no stiffer than the
    /// bodies at any condensed degree of freedom to begin with, and then ten times as stiff, and again, until it is as it is. A deep
    /// start, from which the contact as it is would lead nowhere, may so end where small load steps do. Each of these
    /// equilibria may take `max_iterations`. What is reported is that of the contact as it is.
    pub soft_start: bool,
}

impl Default for ContactStepOptions {
    fn default() -> Self {
        Self {
            tolerance: 1e-10,
            absolute_tolerance: 0.0,
            full_below: 0.1,
            max_iterations: 80,
            max_trials: 12,
            soft_start: false,
        }
    }
}

impl ContactStepOptions {
    pub(super) fn check(&self) -> Result<(), Error> {
        let positive = |name, value: f64| match value.is_finite() && value > 0.0 {
            true => Ok(()),
            false => Err(Error::NotPositive { name, value }),
        };
        positive("tolerance", self.tolerance)?;
        positive("full_below", self.full_below)?;
        Error::check_not_negative("absolute_tolerance", self.absolute_tolerance)?;
        positive("max_iterations", self.max_iterations as f64)?;
        positive("max_trials", self.max_trials as f64)
    }
}

/// How a step ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactStepState {
    /// In equilibrium.
    Converged,
    /// Contact acts on degrees of freedom that are neither on the list nor held: the displacement is what was reached when it
    /// did, and a longer list is needed.
    Outside,
    /// The iterations have run out, or the residual could not be lowered any more; the displacement is what was reached.
    NotConverged,
}

/// Where a step has led.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactStep {
    /// Displacement of the degrees of freedom on the list.
    pub displacement: Vec<f64>,
    /// How it ended.
    pub state: ContactStepState,
    /// Linear systems solved.
    pub iterations: usize,
    /// Evaluations of the contact, without those of its tangent.
    pub evaluations: usize,
    /// Norm of the residual at the start.
    pub residual_at_start: f64,
    /// Norm of the residual that is left.
    pub residual: f64,
    /// What it is compared with: the larger of the norms of the residual given and of the contact forces.
    pub scale: f64,
    /// Number of degrees of freedom outside the list on which contact acts.
    pub outside: usize,
}
