//! The largest stable step.

use super::contact_frequency;
use super::error::DynamicsError;
use super::evaluation::placed;
use super::step_limit::StepLimit;
use crate::fem::Model;
use fmc_contact::Contact;

/// Part of the stable step that is taken when none is given: frequencies rise where cells are compressed.
const SAFETY: f64 = 0.9;

/// What the stable step follows from.
pub(super) struct Stiffness<'a, const D: usize> {
    pub(super) model: &'a Model<D>,
    pub(super) contact: &'a Contact<D>,
    pub(super) mass: &'a [f64],
    pub(super) inverse_mass: &'a [[f64; D]],
}

impl<const D: usize> Stiffness<'_, D> {
    /// Limit for whatever contact may come, at the undeformed bodies.
    pub(super) fn limit_before_contact(&self) -> StepLimit {
        let coords = self.model.coords();
        StepLimit {
            structure: self.model.largest_frequency(&vec![[0.0; D]; coords.len()], self.mass),
            contact: contact_frequency::before_contact(self.contact, coords, self.inverse_mass),
        }
    }

    /// Limit at a displacement, with the contact that there is.
    pub(super) fn limit_at(&self, displacement: &[[f64; D]]) -> Result<StepLimit, DynamicsError> {
        let structure = self.model.largest_frequency(displacement, self.mass);
        Ok(StepLimit { structure, contact: self.contact_frequency(displacement)? })
    }

    /// The limit at a displacement, if the step exceeds it. A bound from single elements comes first: it is a hundred
    /// times cheaper than the frequency, and mostly enough.
    pub(super) fn exceeded(&self, step: f64, displacement: &[[f64; D]]) -> Result<Option<StepLimit>, DynamicsError> {
        let contact = self.contact_frequency(displacement)?;
        let limit = StepLimit { structure: self.model.frequency_bound(displacement, self.mass), contact };
        if step <= limit.step() {
            return Ok(None);
        }
        let limit = StepLimit { structure: self.model.largest_frequency(displacement, self.mass), contact };
        Ok((step > limit.step()).then_some(limit))
    }

    fn contact_frequency(&self, displacement: &[[f64; D]]) -> Result<Option<f64>, DynamicsError> {
        let coords = placed(self.model.coords(), displacement);
        contact_frequency::in_contact(self.contact, &coords, self.inverse_mass).map_err(DynamicsError::Setup)
    }

    /// The limit and the step to take when none is given.
    pub(super) fn auto(&self) -> Result<(StepLimit, f64), DynamicsError> {
        let limit = self.limit_before_contact();
        if limit.step().is_finite() { Ok((limit, SAFETY * limit.step())) } else { Err(DynamicsError::NoLimit) }
    }

    /// The limit at a displacement, if it admits the step asked for.
    pub(super) fn admits(&self, asked: f64, displacement: &[[f64; D]]) -> Result<StepLimit, DynamicsError> {
        let limit = self.limit_at(displacement)?;
        if asked <= limit.step() { Ok(limit) } else { Err(DynamicsError::StepTooLarge { asked, limit }) }
    }
}
