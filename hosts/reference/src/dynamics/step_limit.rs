//! What bounds the step.

use std::fmt;

/// What bounds the step of the leapfrog scheme.
///
/// The linearised motion M ü = −(K_s + K_c) u is stable for Δt ≤ 2/ω, where ω² is the largest eigenvalue of
/// M⁻¹(K_s + K_c). The largest eigenvalue of a sum of symmetric matrices is at most the sum of the largest, so
/// ω² ≤ ω_s² + ω_c², with ω_s from the structure and ω_c from the contact. Supports only lower ω.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepLimit {
    /// Largest frequency of the structure alone, rad/time.
    pub structure: f64,
    /// Bound of the contact's frequency, rad/time; `None` where none exists because the force, or its slope, jumps.
    pub contact: Option<f64>,
}

impl StepLimit {
    /// 2/√(ω_s² + ω_c²), infinite for bodies without stiffness. Where the contact has no bound, that of the structure.
    pub fn step(&self) -> f64 {
        2.0 / self.structure.hypot(self.contact.unwrap_or(0.0))
    }
}

impl fmt::Display for StepLimit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.4e} (structure alone: {:.4e}", self.step(), 2.0 / self.structure)?;
        match self.contact {
            Some(contact) if contact > 0.0 => write!(f, ", contact alone: {:.4e})", 2.0 / contact),
            Some(_) => write!(f, ", no contact)"),
            None => write!(f, "; the contact's force jumps, and no step is small enough to resolve it)"),
        }
    }
}
