//! Bodies that are tied.

use super::Resident;
use crate::capi::boundary::failure::Failure;
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
}
