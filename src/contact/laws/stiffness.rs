//! Suggested values of the stiffness.

use super::EnergyLaw;
use crate::Error;

/// What is known about the contact to come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StiffnessFrom {
    /// Young's modulus E of the softer body (Pa) and the size h of its facets in contact (length). The stiffness is
    /// such that an overlap of depth h/10 over a patch one facet wide gives the traction E.
    Modulus {
        /// Young's modulus, Pa.
        modulus: f64,
        /// Facet size, length.
        facet_size: f64,
    },
    /// The largest contact pressure expected (Pa) and the acceptable overlap at that pressure (2D: area, 3D: volume;
    /// not used for m = 1; for the fiber law the penetration, a length). For the volume law the stiffness is 1.2 times
    /// the one that gives this pressure, since with m = 1 a lower k than the peak pressure lets the bodies pass
    /// through one another; for the fiber law it is the one that gives it.
    PeakPressure {
        /// Pressure, Pa.
        pressure: f64,
        /// Accepted overlap of one pair, length^D; for the fiber law the accepted penetration.
        overlap: f64,
    },
}

/// Stiffness k of the law w = k Vᵐ in `dimension` 2 or 3, with exponent `m`.
///
/// The traction of that law is k m Vᵐ⁻¹, so k = p / (m Vᵐ⁻¹) for a traction p at overlap V. From a modulus,
/// p = E and V = (h/10) hᴰ⁻¹. Units: Pa / (length^D)^(m−1); for m = 1 it is a pressure in 2D and in 3D.
///
/// # Errors
/// [`Error::NotPositive`] for a value that is not positive and finite, or m < 1.
///
/// ```
/// use fmc_contact::contact::{StiffnessFrom, suggest_stiffness};
/// let k = suggest_stiffness(StiffnessFrom::PeakPressure { pressure: 1.0e6, overlap: 1.0e-4 }, 2, 1.0)?;
/// assert_eq!(k, 1.2e6);
/// # Ok::<(), fmc_contact::Error>(())
/// ```
pub fn suggest_stiffness(from: StiffnessFrom, dimension: usize, m: f64) -> Result<f64, Error> {
    EnergyLaw::Volume { stiffness: 1.0, exponent: m }.check()?;
    let (pressure, overlap) = match from {
        StiffnessFrom::Modulus { modulus, facet_size } => {
            (positive("modulus", modulus)?, 0.1 * positive("cell_size", facet_size)?.powi(dimension as i32))
        }
        StiffnessFrom::PeakPressure { pressure, overlap } if m == 1.0 => {
            (1.2 * positive("pressure", pressure)?, overlap)
        }
        StiffnessFrom::PeakPressure { pressure, overlap } => {
            (1.2 * positive("pressure", pressure)?, positive("overlap", overlap)?)
        }
    };
    Ok(if m == 1.0 { pressure } else { pressure / (m * overlap.powf(m - 1.0)) })
}

/// Stiffness k of the quadratic fiber law, pressure = k × penetration, in Pa/length: the pressure is E at a tenth of a
/// facet's size, or the peak pressure at the accepted penetration.
///
/// # Errors
/// [`Error::NotPositive`] for a value that is not positive and finite.
pub fn suggest_fiber_stiffness(from: StiffnessFrom) -> Result<f64, Error> {
    let (pressure, penetration) = match from {
        StiffnessFrom::Modulus { modulus, facet_size } => {
            (positive("modulus", modulus)?, 0.1 * positive("cell_size", facet_size)?)
        }
        StiffnessFrom::PeakPressure { pressure, overlap } => {
            (positive("pressure", pressure)?, positive("penetration", overlap)?)
        }
    };
    Ok(pressure / penetration)
}

fn positive(name: &'static str, value: f64) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(Error::NotPositive { name, value }) }
}
