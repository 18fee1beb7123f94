//! Wear.

use super::Resident;
use crate::capi::boundary::failure::Failure;
use crate::capi::structs::worn_row;
use crate::contact::Wear;

impl<const D: usize> Resident<D> {
    /// Depths at nodes, and volumes of bodies.
    pub(crate) fn wear(&self) -> Result<Wear, Failure> {
        Ok(self.held.contact().wear()?)
    }

    /// What was worn off, as rows.
    pub(crate) fn worn_facets(&self) -> Vec<f64> {
        worn_row::rows(&self.held.contact().worn_facets())
    }

    /// Sets it.
    pub(crate) fn set_worn_facets(&mut self, worn: &[f64]) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_worn_facets(&worn_row::list(worn)?)?)
    }

    /// Sets how often the wear of a step counts.
    pub(crate) fn set_wear_cycles(&mut self, cycles: f64) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_wear_cycles(cycles)?)
    }
}
