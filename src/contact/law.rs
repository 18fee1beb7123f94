//! Energy as a function of overlap.

use crate::Error;

/// Contact energy w of one overlapping pair; nodal forces are −∂w/∂x.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum EnergyLaw {
    /// w = k Vᵐ (paper, Eq. for w(V_c)); m = 1 is the paper's choice.
    ///
    /// With m = 1 the traction is k wherever there is overlap: k is a pressure, and must exceed the peak contact
    /// pressure or the bodies pass through one another. In general the traction is k m Vᵐ⁻¹, one number per pair.
    /// Units: energy / (length^D)ᵐ, in 2D per unit thickness; for m = 1 that is Pa in both dimensions, for m = 2 it is
    /// Pa/m² in 2D and Pa/m³ in 3D.
    Volume {
        /// Stiffness, positive.
        k: f64,
        /// Exponent, at least 1.
        m: f64,
    },
}

impl EnergyLaw {
    /// w = k V.
    pub fn volume(k: f64) -> Self {
        EnergyLaw::Volume { k, m: 1.0 }
    }

    /// Energy of an overlap.
    pub fn energy(&self, volume: f64) -> f64 {
        match *self {
            EnergyLaw::Volume { k, m } => k * volume.max(0.0).powf(m),
        }
    }

    /// dw/dV: the traction. At `volume = 0` it is the one-sided limit, k for m = 1.
    pub fn energy_gradient(&self, volume: f64) -> f64 {
        match *self {
            EnergyLaw::Volume { k, m: 1.0 } => k,
            EnergyLaw::Volume { k, m } => k * m * volume.max(0.0).powf(m - 1.0),
        }
    }

    /// Whether k is positive and finite and m finite and at least 1.
    pub(crate) fn check(&self) -> Result<(), Error> {
        match *self {
            EnergyLaw::Volume { k, .. } if !(k.is_finite() && k > 0.0) => {
                Err(Error::NotPositive { name: "k", value: k })
            }
            EnergyLaw::Volume { m, .. } if !(m.is_finite() && m >= 1.0) => {
                Err(Error::NotPositive { name: "m", value: m })
            }
            _ => Ok(()),
        }
    }
}
