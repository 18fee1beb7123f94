//! Time steps of a case.

use serde::{Deserialize, Serialize};

/// `[time]`. Exactly one of `step` and `fraction`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Time {
    /// Step, s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub step: Option<f64>,
    /// Step, relative to the largest stable one, at most 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fraction: Option<f64>,
    /// Duration, s.
    pub end: f64,
    /// Evaluations of the contact in each step. More than one resolve a force that jumps.
    #[serde(default = "one")]
    pub contact_substeps: u32,
    /// Damping force per velocity and mass, 1/s; none if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub damping: Option<f64>,
}

fn one() -> u32 {
    1
}

impl Default for Time {
    fn default() -> Self {
        Self { step: None, fraction: None, end: 0.0, contact_substeps: one(), damping: None }
    }
}

impl Time {
    /// Whether the case does not speak of time.
    pub fn is_absent(&self) -> bool {
        *self == Self::default()
    }

    /// Steps of the given length that reach the end; what rounding adds to a whole number makes no step.
    pub fn steps(&self, step: f64) -> u64 {
        (self.end / step - 1e-6).ceil().max(1.0) as u64
    }
}
