//! Friction from one time step to the next.

use super::error::DynamicsError;
use super::evaluation::placed;
use super::friction_step::FrictionStep;
use super::simulation::Simulation;

impl<const D: usize> Simulation<D> {
    /// Accepts the slip of the step that led here, and begins the next one. Returns what there was before.
    pub(super) fn commit_friction(&mut self) -> Result<Option<FrictionStep<D>>, DynamicsError> {
        let Some(before) = self.friction_step() else { return Ok(None) };
        let (step, time) = (self.state.step, self.time());
        let coords = self.coords();
        self.contact.commit_step(&coords).map_err(|error| DynamicsError::Contact { step, time, error })?;
        self.step_start = self.state.displacement.clone();
        Ok(Some(before))
    }

    /// The step of friction under way; `None` without friction.
    pub(super) fn friction_step(&self) -> Option<FrictionStep<D>> {
        let slip = self.contact.slip().ok()?;
        Some(FrictionStep { displacement: self.step_start.clone(), slip })
    }

    /// Puts a step of friction back.
    pub(super) fn restore_friction(&mut self, step: Option<FrictionStep<D>>) -> Result<(), DynamicsError> {
        let Some(FrictionStep { displacement, slip }) = step else { return Ok(()) };
        let coords = placed(self.setup.model.coords(), &displacement);
        self.contact.begin_step(&coords).map_err(DynamicsError::Setup)?;
        self.contact.set_slip(&slip).map_err(DynamicsError::Setup)?;
        self.step_start = displacement;
        Ok(())
    }
}
