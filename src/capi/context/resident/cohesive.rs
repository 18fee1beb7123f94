//! Bodies that are held together by interfaces that break.

use super::Resident;
use crate::Error;
use crate::capi::boundary::failure::Failure;
use crate::capi::structs::cohesive::fmc_cohesive_point;
use crate::capi::structs::view::fmc_coords;
use crate::contact::{CohesiveSummary, PointDamage, PointHistory};

impl<const D: usize> Resident<D> {
    pub(crate) unsafe fn cohesive(
        &mut self,
        bodies: [usize; 2],
        coords: &fmc_coords,
        index_base: i32,
    ) -> Result<Option<CohesiveSummary>, Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.cohesive(bodies, rows)) }
    }

    pub(crate) unsafe fn cohesive_points(
        &mut self,
        coords: &fmc_coords,
        index_base: i32,
    ) -> Result<Vec<fmc_cohesive_point>, Failure> {
        // SAFETY: passed on to the caller.
        let found = unsafe { self.at(coords, index_base, |contact, rows| contact.cohesive_points(rows)) }?;
        Ok(found.iter().map(fmc_cohesive_point::from).collect())
    }

    pub(crate) fn damage(&self) -> Result<Vec<f64>, Failure> {
        let found = self.held.contact().damage()?;
        Ok(found.iter().flat_map(|one| [one.damage, one.dissipated]).collect())
    }

    pub(crate) fn cohesive_history(&self) -> Result<Vec<f64>, Failure> {
        let found = self.held.contact().cohesive_history()?;
        Ok(found.iter().flat_map(PointHistory::numbers).collect())
    }

    pub(crate) fn set_cohesive_history(&mut self, history: &[f64]) -> Result<(), Failure> {
        let (rows, rest) = history.as_chunks::<{ PointHistory::COUNT }>();
        if !rest.is_empty() {
            let expected = PointHistory::COUNT * self.held.contact().damage()?.len();
            return Err(Error::Length { array: "history", expected, found: history.len() }.into());
        }
        let list: Vec<_> = rows.iter().copied().map(PointHistory::of_numbers).collect();
        Ok(self.held.contact_mut().set_cohesive_history(&list)?)
    }

    pub(crate) fn set_time_step(&mut self, time_step: f64) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_time_step(time_step)?)
    }

    pub(crate) fn set_damage(&mut self, damage: &[f64]) -> Result<(), Failure> {
        let (rows, rest) = damage.as_chunks::<2>();
        if !rest.is_empty() {
            let expected = 2 * self.held.contact().damage()?.len();
            return Err(Error::Length { array: "damage", expected, found: damage.len() }.into());
        }
        let list: Vec<_> = rows.iter().map(|&[damage, dissipated]| PointDamage { damage, dissipated }).collect();
        Ok(self.held.contact_mut().set_damage(&list)?)
    }
}
