//! The linear fiber law made sharp.

use super::balance::Balance;
use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::report::Watch;
use super::search::Reached;
use fmc_contact::{EnergyLaw, EnergyProfile, PenetrationLaw};

/// Part to which ε is reduced at once: smaller ones cost more iterations than they save.
const STRIDE: f64 = 0.3;

/// Strides of less than this are given up.
const LEAST_STRIDE: f64 = 0.97;

impl<const D: usize> Equilibrium<D> {
    /// From the last equilibrium to that of the law ψ = k(√(L² + ε²) − ε) with a smaller ε, in strides to 0.3 of it or,
    /// where that fails, shorter ones. The pressures hardly change; the penetration falls with ε.
    ///
    /// # Errors
    /// Those of [`StaticsError`]; the last equilibrium is kept, with its ε in force. Other laws are left alone.
    pub fn continue_smoothing(&mut self, target: f64, watch: Watch) -> Result<(), StaticsError> {
        let mut stride = STRIDE;
        while let EnergyLaw::Fiber(PenetrationLaw { stiffness: k, profile: EnergyProfile::Linear { smoothing_length } }) =
            self.problem.contact.law
            && smoothing_length > target
        {
            let next = (stride * smoothing_length).max(target);
            self.set_law(EnergyLaw::Fiber(PenetrationLaw {
                stiffness: k,
                profile: EnergyProfile::Linear { smoothing_length: next },
            }))?;
            match self.search(&self.displacement.clone(), self.load, true, watch) {
                Ok(Reached { displacement, balance }) => {
                    self.accept(displacement, balance, self.load);
                    self.commit_step()?;
                    stride = STRIDE.max(stride * stride);
                }
                Err(StaticsError::Interrupted) => return Err(StaticsError::Interrupted),
                Err(error) => {
                    self.set_law(EnergyLaw::Fiber(PenetrationLaw {
                        stiffness: k,
                        profile: EnergyProfile::Linear { smoothing_length },
                    }))?;
                    stride = stride.sqrt();
                    if stride > LEAST_STRIDE {
                        return Err(self.too_soft(&self.balance).unwrap_or(error));
                    }
                }
            }
        }
        self.too_soft(&self.balance).map_or(Ok(()), Err)
    }

    /// With the linear law, whether bodies pass through one another: the pressure is then that of the law far from
    /// zero.
    pub(super) fn too_soft(&self, balance: &Balance<D>) -> Option<StaticsError> {
        let penetration = balance.contact.penetration;
        match self.problem.contact.law {
            // k L/√(L² + ε²) is k to 0.5 % at L = 10 ε: what resists more is elastic, or nothing.
            EnergyLaw::Fiber(PenetrationLaw { stiffness: k, profile: EnergyProfile::Linear { smoothing_length } })
                if penetration > 10.0 * smoothing_length =>
            {
                Some(StaticsError::PeakPressureAboveStiffness { stiffness: k, penetration, smoothing_length })
            }
            _ => None,
        }
    }
}
