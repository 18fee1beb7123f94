//! What a step is asked for, and what is said of it.

use crate::Error;

/// When a step ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactStepOptions {
    /// Residual, by the larger of the norms of the residual given and of the contact forces, at which a step has converged.
    pub tolerance: f64,
    /// Residual, a force, at which it has converged too; 0: none. Bodies that are not linear need no more than a part of what
    /// their linearisation leaves.
    pub goal: f64,
    /// Relative residual below which the full tangent is taken.
    pub full_below: f64,
    /// Iterations, at most.
    pub most_iterations: usize,
    /// Trials along a direction, at most.
    pub most_trials: usize,
    /// Largest mean penetration of a node that is wanted, a length; 0: that of the law, as it is. Where the law leaves more, an
    /// augmented Lagrangian takes over, whose pressures at nodes need no penetration: for laws whose pressure grows with it, without
    /// friction and self-contact.
    pub penetration: f64,
    /// How far from a partner gaps are measured for it, a length; 0: a twentieth of the bodies' extent.
    pub reach: f64,
    /// Updates of these pressures, at most.
    pub most_updates: usize,
    /// Whether softer contacts come first where the first step of Newton's method cannot be taken whole: where it would not lower
    /// the energy (without an energy, the residual), or would turn a cell inside out. The contact is then no stiffer than the
    /// bodies at any condensed degree of freedom to begin with, and then ten times as stiff, and again, until it is as it is. A deep
    /// start, from which the contact as it is would lead nowhere, may so end where small load steps do. Each of these
    /// equilibria may take `most_iterations`. What is reported is that of the contact as it is.
    pub soft_start: bool,
}

impl Default for ContactStepOptions {
    fn default() -> Self {
        Self {
            tolerance: 1e-10,
            goal: 0.0,
            full_below: 0.1,
            most_iterations: 80,
            most_trials: 12,
            penetration: 0.0,
            reach: 0.0,
            most_updates: 20,
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
        for (name, value) in [("goal", self.goal), ("penetration", self.penetration), ("reach", self.reach)] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(Error::NotPositive { name, value });
            }
        }
        positive("most_updates", self.most_updates as f64)?;
        positive("most_iterations", self.most_iterations as f64)?;
        positive("most_trials", self.most_trials as f64)
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
    /// The iterations have run out, or the residual could not be lowered any more, or the penetration; the displacement is what was
    /// reached.
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
    /// Updates of the pressures of an augmented Lagrangian.
    pub updates: usize,
    /// Largest mean penetration of a node at the end, where one was asked for; else 0.
    pub penetration: f64,
}
