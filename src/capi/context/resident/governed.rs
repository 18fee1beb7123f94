//! Bodies that are held together by laws of the host.

use super::Resident;
use crate::capi::boundary::failure::Failure;
use crate::capi::structs::law_point::fmc_law_point;
use crate::capi::structs::own_law::OwnLaw;
use crate::capi::structs::view::fmc_coords;
use crate::contact::PairOptions;
use crate::overlap::Partner;
use std::sync::Arc;

impl<const D: usize> Resident<D> {
    /// Sets the options of a pair with its law; it goes on to wear as it did.
    pub(crate) fn set_law_pair(
        &mut self,
        partners: [Partner; 2],
        options: PairOptions,
        law: Arc<OwnLaw>,
    ) -> Result<(), Failure> {
        let wear_coefficients = self.pair_options(partners)?.wear_coefficients;
        let options = PairOptions { wear_coefficients, ..options };
        Ok(self.held.contact_mut().set_law_pair(partners, options, law)?)
    }

    pub(crate) fn set_law_fields(&mut self, count: usize, values: &[f64]) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_law_fields(count, values)?)
    }

    pub(crate) unsafe fn law_points(
        &mut self,
        coords: &fmc_coords,
        index_base: i32,
    ) -> Result<Vec<fmc_law_point>, Failure> {
        // SAFETY: passed on to the caller.
        let found = unsafe { self.at(coords, index_base, |contact, rows| contact.law_points(rows)) }?;
        Ok(found.iter().map(fmc_law_point::from).collect())
    }

    pub(crate) fn law_history(&self) -> Result<Vec<f64>, Failure> {
        Ok(self.held.contact().law_history()?)
    }

    pub(crate) fn set_law_history(&mut self, history: &[f64]) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_law_history(history)?)
    }
}
