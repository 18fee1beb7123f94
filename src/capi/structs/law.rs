//! The laws among the options: numbers, names, and the law of the crate that they and its fields say.

use super::choice::Choice;
use crate::capi::boundary::failure::Failure;
use crate::{EnergyLaw, EnergyProfile, PenetrationLaw};

/// Contact energy.
#[repr(C)]
pub enum fmc_law {
    /// w = k V^m for every overlapping pair; k is `stiffness`, m is `exponent`. Key value "volume".
    FMC_LAW_VOLUME = 0,
    /// w = sum of psi(L) over lines along the mean normal of the contact, L being the penetration on each. Without
    /// `smoothing_length`, psi = k L^2 / 2, the pressure is k L, and k, the `stiffness`, is a pressure per length. With
    /// a smoothing length s, psi = k (sqrt(L^2 + s^2) - s), and k is a pressure as for "volume" with exponent 1. Key
    /// value "fiber".
    FMC_LAW_FIBER = 1,
    /// w = k/2 times the integral of g_A + g_B over the overlap, where g_A and g_B are the depths of both bodies'
    /// material below their surfaces. Against an obstacle w is k times the integral of the depth below its surface.
    /// Flat faces press with k times their penetration, as with "fiber", and k is a pressure per length. There are no
    /// directions and no patches, and the energy is continuous for any motion of corners, edges and whole bodies.
    /// Bodies need cells. It is measured without lines under every estimator. Key value "depth".
    FMC_LAW_DEPTH = 2,
}

pub(crate) const LAW: Choice = Choice {
    key: "law",
    values: &[
        (fmc_law::FMC_LAW_VOLUME as i32, "volume"),
        (fmc_law::FMC_LAW_FIBER as i32, "fiber"),
        (fmc_law::FMC_LAW_DEPTH as i32, "depth"),
    ],
};

/// The fields of options that say a law.
#[derive(Clone, Copy)]
pub(crate) struct LawFields {
    pub(crate) law: i32,
    pub(crate) stiffness: f64,
    pub(crate) exponent: f64,
    pub(crate) smoothing_length: f64,
}

impl LawFields {
    pub(crate) fn read(self) -> Result<EnergyLaw, Failure> {
        let Self { law, stiffness, exponent, smoothing_length } = self;
        let profile = match smoothing_length {
            0.0 => EnergyProfile::Quadratic,
            smoothing_length => EnergyProfile::Linear { smoothing_length },
        };
        Ok(match LAW.name(law)? {
            "fiber" => EnergyLaw::Fiber(PenetrationLaw { stiffness, profile }),
            "depth" => EnergyLaw::Depth { stiffness },
            _ => EnergyLaw::Volume { stiffness, exponent },
        })
    }
}

impl From<EnergyLaw> for LawFields {
    fn from(law: EnergyLaw) -> Self {
        let fields = |law: fmc_law| Self { law: law as i32, stiffness: 0.0, exponent: 1.0, smoothing_length: 0.0 };
        match law {
            EnergyLaw::Volume { stiffness, exponent } => {
                Self { stiffness, exponent, ..fields(fmc_law::FMC_LAW_VOLUME) }
            }
            EnergyLaw::Depth { stiffness } => Self { stiffness, ..fields(fmc_law::FMC_LAW_DEPTH) },
            EnergyLaw::Fiber(PenetrationLaw { stiffness, profile }) => {
                let smoothing_length = match profile {
                    EnergyProfile::Quadratic => 0.0,
                    EnergyProfile::Linear { smoothing_length } => smoothing_length,
                };
                Self { stiffness, smoothing_length, ..fields(fmc_law::FMC_LAW_FIBER) }
            }
        }
    }
}
