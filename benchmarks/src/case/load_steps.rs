//! Load steps of a case of statics.

use serde::{Deserialize, Serialize};

/// `[load_steps]`, instead of `[time]`: the case is about equilibrium. Loads and prescribed displacements grow
/// together from zero.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct LoadSteps {
    /// Number of equal steps. A step that fails is halved.
    pub count: usize,
    /// Number of equal steps of each further stage, in which the supports move to the values of their `then`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub then: Vec<usize>,
    /// Residual at equilibrium, relative to the forces.
    pub tolerance: f64,
    /// Largest number of iterations of a step.
    pub most_iterations: usize,
    /// Penetration tolerance: largest mean penetration of a node at the end of each step, m. Without it the law alone decides. With the
    /// laws `fiber` and `depth`, without friction and self-contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub penetration: Option<f64>,
}

impl Default for LoadSteps {
    fn default() -> Self {
        Self { count: 1, then: Vec::new(), tolerance: 1e-10, most_iterations: 60, penetration: None }
    }
}
