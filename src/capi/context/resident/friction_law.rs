//! Pairs that slide by laws of the host.

use super::Resident;
use crate::capi::boundary::failure::Failure;
use crate::capi::structs::friction_law::HostFriction;
use crate::contact::PairOptions;
use crate::overlap::Partner;
use std::sync::Arc;

impl<const D: usize> Resident<D> {
    pub(crate) fn set_friction_law_pair(
        &mut self,
        partners: [Partner; 2],
        options: PairOptions,
        law: Arc<HostFriction>,
    ) -> Result<(), Failure> {
        // A pair that wears goes on to do so, which is refused here.
        let wear_coefficients = self.pair_options(partners)?.wear_coefficients;
        let options = PairOptions { wear_coefficients, ..options };
        Ok(self.held.contact_mut().set_friction_law_pair(partners, options, law)?)
    }

    pub(crate) fn friction_history(&self) -> Result<Vec<f64>, Failure> {
        Ok(self.held.contact().friction_history()?)
    }

    pub(crate) fn set_friction_history(&mut self, history: &[f64]) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_friction_history(history)?)
    }
}
