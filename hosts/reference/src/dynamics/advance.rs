//! The leapfrog scheme, step by step.

use super::error::DynamicsError;
use super::evaluation::{Structure, Touch, sum};
use super::sample::Sample;
use super::simulation::Simulation;
use std::time::Instant;

impl<const D: usize> Simulation<D> {
    /// Makes one step.
    ///
    /// # Errors
    /// [`DynamicsError::Contact`], [`DynamicsError::InvertedCell`], [`DynamicsError::NonFinite`]; the simulation is then
    /// as it was before.
    pub fn advance(&mut self) -> Result<Sample<D>, DynamicsError> {
        let before = self.commit_friction()?;
        let stepped = self.advance_committed();
        if stepped.is_err() {
            self.restore_friction(before)?;
        }
        stepped
    }

    /// The same, once the step of friction that led here is accepted.
    fn advance_committed(&mut self) -> Result<Sample<D>, DynamicsError> {
        let clock = Instant::now();
        let mut next = self.state.clone();
        next.step += 1;
        let time = next.step as f64 * self.step_size;
        let damped = self.setup.damping > 0.0;
        let decay = (-0.5 * self.setup.damping * self.step_size).exp();
        if damped {
            next.decay(decay, &self.mass);
        }
        if self.setup.new_fibers_every_step {
            self.contact.set_options(self.setup.options_at(next.step)).map_err(DynamicsError::Setup)?;
        }
        let actors = self.actors(next.step, time);
        let (half, substeps) = (0.5 * self.step_size, self.setup.contact_substeps.max(1));
        next.kick(&self.structure.acceleration, half);
        let mut touch: Option<Touch<D>> = None;
        let mut contact_seconds = 0.0;
        let mut resultants = vec![[0.0; D]; self.resultants.len()];
        for _ in 0..substeps {
            let duration = self.step_size / f64::from(substeps);
            next.kick(&touch.as_ref().unwrap_or(&self.touch).acceleration, 0.5 * duration);
            next.drift(duration);
            if let Some(node) = next.non_finite_node() {
                return Err(DynamicsError::NonFinite { step: next.step, time, node });
            }
            let now = actors.touch(&next.displacement)?;
            next.kick(&now.acceleration, 0.5 * duration);
            contact_seconds += now.seconds;
            for (mean, force) in resultants.iter_mut().zip(now.resultants()) {
                (0..D).for_each(|axis| mean[axis] += force[axis] / f64::from(substeps));
            }
            touch = Some(now);
        }
        let structure = actors.structure(&next.displacement)?;
        next.kick(&structure.acceleration, half);
        if damped {
            next.decay(decay, &self.mass);
        }
        (self.state, self.structure, self.resultants) = (next, structure, resultants);
        if let Some(touch) = touch {
            self.state.dissipated += touch.forces.friction.dissipated;
            self.touch = touch;
        }
        self.state.acceleration = sum(&self.structure.acceleration, &self.touch.acceleration);
        let mut sample = self.sample();
        sample.warnings.extend(self.check_step()?);
        sample.contact_seconds = contact_seconds;
        sample.seconds = clock.elapsed().as_secs_f64();
        Ok(sample)
    }

    /// A warning where the step exceeds what is stable now; looked at every [`Setup::check_every`] steps.
    fn check_step(&self) -> Result<Option<String>, DynamicsError> {
        if self.setup.check_every == 0 || !self.state.step.is_multiple_of(self.setup.check_every) {
            return Ok(None);
        }
        let exceeded = self.stiffness().exceeded(self.step_size, &self.state.displacement)?;
        Ok(exceeded.map(|limit| format!("the step of {:.4e} exceeds what is stable now: {limit}", self.step_size)))
    }

    /// Energies and resultants now. After [`Self::advance`] they are those it returned, but for its timings and for the
    /// warning of the step.
    pub fn sample(&self) -> Sample<D> {
        let (Structure { strain, external, .. }, contact) = (&self.structure, &self.touch.forces);
        let kinetic = self.state.kinetic(&self.mass);
        let stored = contact.energy + contact.friction.stored;
        let (bodies, obstacles) = self.resultants.split_at(contact.bodies.len());
        let sum = |axis: usize| self.resultants.iter().map(|f| f[axis]).sum::<f64>();
        Sample {
            step: self.state.step,
            time: self.time(),
            kinetic,
            strain: *strain,
            contact: stored,
            external: *external,
            total: kinetic + strain + stored + external,
            dissipated: self.state.dissipated,
            balance: (0..D).map(|axis| sum(axis).powi(2)).sum::<f64>().sqrt(),
            bodies: bodies.to_vec(),
            obstacles: obstacles.to_vec(),
            velocities: (0..self.setup.model.parts().len()).map(|part| self.mean_velocity(part)).collect(),
            overlap: contact.volume,
            penetration: contact.penetration,
            contact_area: contact.contact_area,
            fibers: contact.fiber_count,
            crossings: contact.crossing_count,
            warnings: contact.warnings.iter().map(ToString::to_string).collect(),
            contact_seconds: 0.0,
            seconds: 0.0,
        }
    }

    /// Velocity of the centre of mass of a part.
    fn mean_velocity(&self, part: usize) -> [f64; D] {
        let momentum = |axis: usize| -> f64 {
            self.setup.model.nodes_of(part).map(|node| self.mass[node] * self.state.velocity[node][axis]).sum()
        };
        std::array::from_fn(|axis| momentum(axis) / self.part_mass(part))
    }
}
