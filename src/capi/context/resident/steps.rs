//! What is kept from one step to the next.

use super::Resident;
use crate::Error;
use crate::capi::boundary::failure::Failure;
use crate::capi::structs::multiplier::fmc_multiplier;
use crate::capi::structs::slip_row;
use crate::capi::structs::view::{check_node_count, fmc_coords};
use crate::contact::equilibrium::StepLimit;
use crate::contact::{Adjustment, Augmentation};

impl<const D: usize> Resident<D> {
    /// Begins a step with friction.
    pub(crate) unsafe fn begin_step(&mut self, coords: &fmc_coords, index_base: i32) -> Result<(), Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.begin_step(rows)) }
    }

    /// Accepts it.
    pub(crate) unsafe fn commit_step(&mut self, coords: &fmc_coords, index_base: i32) -> Result<(), Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.commit_step(rows)) }
    }

    /// Freezes friction at these coordinates, or releases it.
    pub(crate) unsafe fn freeze_friction(
        &mut self,
        coords: Option<&fmc_coords>,
        index_base: i32,
    ) -> Result<(), Failure> {
        let Some(coords) = coords else {
            self.held.contact_mut().release_friction();
            return Ok(());
        };
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.freeze_friction(rows)) }
    }

    /// The elastic slip that was carried into the step.
    pub(crate) fn slip(&self) -> Result<Vec<f64>, Failure> {
        Ok(slip_row::rows(&self.held.contact().slip()?))
    }

    /// Sets it.
    pub(crate) fn set_slip(&mut self, slip: &[f64]) -> Result<(), Failure> {
        self.held.contact().slip()?;
        let list = slip_row::list(slip)?;
        Ok(self.held.contact_mut().set_slip(&list)?)
    }

    /// Keeps the patches at these coordinates, or none; returns the number of directions.
    pub(crate) unsafe fn keep_patches(
        &mut self,
        coords: Option<&fmc_coords>,
        index_base: i32,
    ) -> Result<usize, Failure> {
        let Some(coords) = coords else {
            self.held.contact_mut().release_patches();
            return Ok(0);
        };
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.keep_patches(rows)) }
    }

    /// Largest time step of central differences.
    pub(crate) unsafe fn stable_step(
        &mut self,
        coords: &fmc_coords,
        masses: &[f64],
        index_base: i32,
    ) -> Result<f64, Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.stable_step(rows, masses)) }
    }

    /// Closes gaps up to the first length and removes overlaps up to the second.
    pub(crate) unsafe fn adjust(
        &mut self,
        coords: &fmc_coords,
        [close, remove]: [f64; 2],
        index_base: i32,
    ) -> Result<Adjustment, Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.adjust(rows, close, remove)) }
    }

    /// How far the surface lies beside its nodes.
    pub(crate) fn offsets(&self) -> Vec<f64> {
        self.held.contact().offsets().into_flattened()
    }

    /// Sets it.
    pub(crate) fn set_offsets(&mut self, offsets: &[f64]) -> Result<(), Failure> {
        let (rows, rest) = offsets.as_chunks::<D>();
        if !rest.is_empty() {
            let expected = self.held.contact().offsets().len() * D;
            return Err(Error::Length { array: "offsets", expected, found: offsets.len() }.into());
        }
        Ok(self.held.contact_mut().set_offsets(rows)?)
    }

    /// Stiffness of the contact from masses.
    pub(crate) unsafe fn stiffness_from_masses(
        &mut self,
        coords: &fmc_coords,
        masses: &[f64],
        limit: f64,
        index_base: i32,
    ) -> Result<(), Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.stiffness_from_masses(rows, masses, limit)) }
    }

    /// How far a step may go.
    pub(crate) unsafe fn step_limit(
        &mut self,
        coords: &fmc_coords,
        step: &fmc_coords,
        index_base: i32,
    ) -> Result<StepLimit, Failure> {
        check_node_count(step.node_count, self.held.contact().surface().unknown_count())?;
        let mut scratch = Vec::new();
        // SAFETY: passed on to the caller.
        unsafe {
            let step = step.rows("step", &mut scratch)?;
            self.at(coords, index_base, |contact, rows| contact.step_limit(rows, step))
        }
    }

    /// Moves surfaces out by their gaps.
    pub(crate) unsafe fn augment(
        &mut self,
        coords: &fmc_coords,
        reach: f64,
        enough: f64,
        index_base: i32,
    ) -> Result<Augmentation, Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.augment(rows, reach, enough)) }
    }

    /// Multiplies the stiffness of the laws.
    pub(crate) fn stiffen(&mut self, factor: f64) -> Result<(), Failure> {
        Ok(self.held.contact_mut().stiffen(factor)?)
    }

    /// How far they are moved out.
    pub(crate) fn multipliers(&self, index_base: i32) -> Vec<fmc_multiplier> {
        let found = self.held.contact().multipliers();
        found.iter().map(|one| fmc_multiplier::new(one, index_base)).collect()
    }

    /// Sets it.
    pub(crate) fn set_multipliers(&mut self, multipliers: &[fmc_multiplier], index_base: i32) -> Result<(), Failure> {
        let taken = multipliers.iter().enumerate().map(|(place, one)| one.taken(place, index_base));
        let taken = taken.collect::<Result<Vec<_>, _>>()?;
        self.held.contact_mut().set_multipliers(&taken).map_err(Failure::counted_from(index_base))
    }
}
