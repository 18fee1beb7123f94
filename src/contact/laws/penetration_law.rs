//! Energy of a penetration.

use crate::Error;

/// The energy k ψ(L), by measure across it, of a line that has the length L inside both bodies, its penetration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PenetrationLaw {
    /// k, positive: Pa/length for [`EnergyProfile::Quadratic`], Pa for [`EnergyProfile::Linear`].
    pub stiffness: f64,
    /// ψ.
    pub profile: EnergyProfile,
}

/// Energy ψ of a penetration, per measure across it, for a stiffness of 1.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum EnergyProfile {
    /// ψ = ½ L²: the pressure is k times the penetration. Smooth (C¹) where contact begins.
    Quadratic,
    /// ψ = √(L² + ε²) − ε: for ε → 0 the paper's m = 1, pressure k wherever there is overlap; smooth for ε > 0.
    Linear {
        /// Smoothing length ε > 0, over which the pressure grows to k.
        smoothing_length: f64,
    },
}

impl PenetrationLaw {
    /// Pressure = k × penetration.
    pub fn quadratic(stiffness: f64) -> Self {
        Self { stiffness, profile: EnergyProfile::Quadratic }
    }

    /// Energy of a penetration by measure across it; 0 for a negative one.
    pub fn energy(&self, penetration: f64) -> f64 {
        let (k, x) = (self.stiffness, penetration.max(0.0));
        match self.profile {
            EnergyProfile::Quadratic => 0.5 * k * x * x,
            // √(L² + ε²) − ε without cancellation.
            EnergyProfile::Linear { smoothing_length } => k * x * (x / (x.hypot(smoothing_length) + smoothing_length)),
        }
    }

    /// Its first derivative: the pressure.
    pub fn energy_gradient(&self, penetration: f64) -> f64 {
        let (k, x) = (self.stiffness, penetration.max(0.0));
        match self.profile {
            EnergyProfile::Quadratic => k * x,
            EnergyProfile::Linear { smoothing_length } => k * (x / x.hypot(smoothing_length)),
        }
    }

    /// Its second derivative; at 0 the one-sided limit.
    pub fn energy_hessian(&self, penetration: f64) -> f64 {
        let (k, x) = (self.stiffness, penetration.max(0.0));
        match self.profile {
            EnergyProfile::Quadratic => k,
            EnergyProfile::Linear { smoothing_length } => {
                let r = x.hypot(smoothing_length);
                k * (smoothing_length / r) * (smoothing_length / r) / r
            }
        }
    }

    /// Checks that k is positive and finite, and ε.
    pub(super) fn check(&self) -> Result<(), Error> {
        check_positive("stiffness", self.stiffness)?;
        match self.profile {
            EnergyProfile::Quadratic => Ok(()),
            EnergyProfile::Linear { smoothing_length } => check_positive("smoothing_length", smoothing_length),
        }
    }
}

/// Checks a value that an option of this name has.
pub(super) fn check_positive(name: &'static str, value: f64) -> Result<(), Error> {
    if value.is_finite() && value > 0.0 { Ok(()) } else { Err(Error::NotPositive { name, value }) }
}
