//! Load steps of a case of statics.

use serde::{Deserialize, Serialize};

/// `[load_steps]`, in the place of `[time]`: the case is about equilibrium, and loads and prescribed displacements grow
/// together from nothing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct LoadSteps {
    /// Equal steps that are tried; one that fails is halved.
    pub count: usize,
    /// Equal steps of every further stage, in which the supports move on to the values of their `then`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub then: Vec<usize>,
    /// Residual by the forces at which a state counts as balanced.
    pub tolerance: f64,
    /// Iterations of one step, at most.
    pub most_iterations: usize,
    /// Largest mean penetration of a node that is wanted at the end of every step, m; that of the law if absent. With the laws `fiber`
    /// and `depth`, without friction and self-contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub penetration: Option<f64>,
}

impl Default for LoadSteps {
    fn default() -> Self {
        Self { count: 1, then: Vec::new(), tolerance: 1e-10, most_iterations: 60, penetration: None }
    }
}
