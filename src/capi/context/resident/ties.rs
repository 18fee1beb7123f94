//! Bodies that are tied.

use super::Resident;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::slice;
use crate::capi::structs::tie::{TieRows, fmc_tie_node};
use crate::capi::structs::view::fmc_coords;
use crate::contact::TieSummary;

impl<const D: usize> Resident<D> {
    pub(crate) fn tie(&self, bodies: [usize; 2]) -> Result<Option<TieSummary>, Failure> {
        Ok(self.held.contact().tie(bodies)?)
    }

    pub(crate) unsafe fn tie_nodes(
        &mut self,
        coords: &fmc_coords,
        index_base: i32,
    ) -> Result<Vec<fmc_tie_node>, Failure> {
        // SAFETY: passed on to the caller.
        let found = unsafe { self.at(coords, index_base, |contact, rows| contact.tie_nodes(rows)) }?;
        Ok(found.iter().map(|one| fmc_tie_node::new(one, index_base)).collect())
    }

    pub(crate) fn tie_constraints(&self) -> Result<TieRows, Failure> {
        Ok(TieRows::new::<D>(&self.held.contact().tie_constraints()?))
    }

    pub(crate) unsafe fn add_tie(
        &mut self,
        surfaces: [usize; 2],
        period: *const f64,
        reach: f64,
    ) -> Result<usize, Failure> {
        // SAFETY: passed on to the caller.
        let period = unsafe { vector("period", period) }?;
        Ok(self.held.contact_mut().add_tie(surfaces, period, reach)?)
    }

    pub(crate) fn remove_tie(&mut self, tie: usize) -> Result<(), Failure> {
        Ok(self.held.contact_mut().remove_tie(tie)?)
    }

    pub(crate) unsafe fn set_tie_jump(&mut self, tie: usize, jump: *const f64) -> Result<(), Failure> {
        // SAFETY: passed on to the caller.
        let jump = unsafe { vector("jump", jump) }?;
        Ok(self.held.contact_mut().set_tie_jump(tie, jump)?)
    }

    pub(crate) fn added_tie(&self, tie: usize) -> Result<TieSummary, Failure> {
        Ok(self.held.contact().added_tie(tie)?)
    }

    pub(crate) unsafe fn tie_force(
        &mut self,
        tie: usize,
        coords: &fmc_coords,
        index_base: i32,
    ) -> Result<Vec<f64>, Failure> {
        // SAFETY: passed on to the caller.
        let force = unsafe { self.at(coords, index_base, |contact, rows| contact.tie_force(tie, rows)) }?;
        Ok(force.to_vec())
    }
}

/// `D` numbers of the host.
unsafe fn vector<const D: usize>(name: &'static str, given: *const f64) -> Result<[f64; D], Failure> {
    // SAFETY: passed on to the caller.
    let given = unsafe { slice(name, given, 1, D) }?;
    Ok(std::array::from_fn(|axis| given[axis]))
}
