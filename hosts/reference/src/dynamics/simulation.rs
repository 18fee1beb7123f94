//! The leapfrog scheme.

use super::checkpoint::Checkpoint;
use super::error::{CheckpointError, DynamicsError};
use super::evaluation::{Actors, Evaluation, placed};
use super::fingerprint::fingerprint;
use super::sample::Sample;
use super::setup::{Setup, Step};
use super::state::State;
use super::step_limit::{StepLimit, Stiffness};
use crate::fem::Model;
use fmc_contact::{Contact, ContactForces};
use std::path::Path;
use std::time::Instant;

/// Bodies in motion.
///
/// ```text
/// v(n+½) = v(n)   + ½ Δt a(n)          kick
/// u(n+1) = u(n)   +   Δt v(n+½)        drift
/// a(n+1) = M⁻¹ (f_external + f_contact(u(n+1)) − f_internal(u(n+1)))
/// v(n+1) = v(n+½) + ½ Δt a(n+1)        kick
/// ```
///
/// Damping, where asked for, multiplies v by exp(−α Δt/2) before and after: its exact flow, so that it is stable for any
/// α and the scheme stays of second order.
pub struct Simulation<const D: usize> {
    setup: Setup<D>,
    contact: Contact<D>,
    mass: Vec<f64>,
    inverse_mass: Vec<[f64; D]>,
    step_size: f64,
    limit: StepLimit,
    state: State<D>,
    evaluation: Evaluation<D>,
}

impl<const D: usize> Simulation<D> {
    /// Starts at time 0 with the setup's velocity.
    ///
    /// # Errors
    /// [`DynamicsError::StepTooLarge`] naming the limit; those of the setup's values and of the first evaluation.
    pub fn start(setup: Setup<D>) -> Result<Self, DynamicsError> {
        let count = setup.model.node_count();
        let mut state = State {
            step: 0,
            displacement: vec![[0.0; D]; count],
            velocity: setup.velocity.clone(),
            acceleration: Vec::new(),
            dissipated: 0.0,
        };
        state.velocity.resize(if setup.velocity.is_empty() { count } else { setup.velocity.len() }, [0.0; D]);
        Self::at(setup, state, None)
    }

    /// Goes on from a file that [`Self::save`] wrote: bit for bit as if there had been no interruption.
    ///
    /// # Errors
    /// [`DynamicsError::Checkpoint`] if the file is damaged, or belongs to another setup or another step; those of
    /// [`Self::start`].
    pub fn resume(setup: Setup<D>, path: &Path) -> Result<Self, DynamicsError> {
        let Checkpoint { fingerprint: found, step_size, state } = Checkpoint::read(path)?;
        if found != fingerprint(&setup) || state.displacement.len() != setup.model.node_count() {
            return Err(CheckpointError::OtherModel.into());
        }
        match setup.step {
            Step::Fixed(asked) if asked != step_size => {
                Err(CheckpointError::OtherStep { found: step_size, asked }.into())
            }
            _ => Self::at(setup, state, Some(step_size)),
        }
    }

    /// Writes the state to a file, whole or not at all.
    ///
    /// # Errors
    /// [`CheckpointError::File`].
    pub fn save(&self, path: &Path) -> Result<(), CheckpointError> {
        let (fingerprint, step_size) = (fingerprint(&self.setup), self.step_size);
        Checkpoint { fingerprint, step_size, state: self.state.clone() }.write(path)
    }

    fn at(setup: Setup<D>, mut state: State<D>, saved_step: Option<f64>) -> Result<Self, DynamicsError> {
        setup.check()?;
        let mass = setup.model.lumped_mass();
        let mut inverse_mass: Vec<[f64; D]> = mass.iter().map(|m| [1.0 / m; D]).collect();
        setup.supports.clear(&mut inverse_mass);
        if saved_step.is_none() {
            setup.supports.apply(&mut state.displacement);
            setup.supports.clear(&mut state.velocity);
        }
        let surface = setup.model.surface().map_err(DynamicsError::Setup)?;
        let mut contact = Contact::new(surface, setup.options_at(state.step)).map_err(DynamicsError::Setup)?;
        for obstacle in &setup.obstacles {
            contact.add_obstacle(obstacle.clone()).map_err(DynamicsError::Setup)?;
        }
        let stiffness = Stiffness { model: &setup.model, contact: &contact, mass: &mass, inverse_mass: &inverse_mass };
        let (limit, step_size) = match (saved_step, setup.step) {
            (None, Step::Auto) => stiffness.auto()?,
            (None, Step::Fixed(asked)) => (stiffness.admits(asked, &state.displacement)?, asked),
            (Some(saved), _) => (stiffness.limit_before_contact(), saved),
        };
        let time = state.step as f64 * step_size;
        let actors = Actors { model: &setup.model, contact: &contact, load: &setup.load, inverse_mass: &inverse_mass };
        let evaluation = actors.evaluate(&state.displacement, state.step, time)?;
        state.acceleration.clone_from(&evaluation.acceleration);
        Ok(Self { setup, contact, mass, inverse_mass, step_size, limit, state, evaluation })
    }

    /// Makes one step.
    ///
    /// # Errors
    /// [`DynamicsError::Contact`], [`DynamicsError::InvertedCell`], [`DynamicsError::NonFinite`]; the simulation is then
    /// as it was before.
    pub fn advance(&mut self) -> Result<Sample<D>, DynamicsError> {
        let clock = Instant::now();
        let mut next = self.state.clone();
        next.step += 1;
        let time = next.step as f64 * self.step_size;
        let damped = self.setup.damping > 0.0;
        let decay = (-0.5 * self.setup.damping * self.step_size).exp();
        if damped {
            next.decay(decay, &self.mass);
        }
        next.kick(self.step_size);
        next.drift(self.step_size);
        if let Some(node) = next.non_finite_node() {
            return Err(DynamicsError::NonFinite { step: next.step, time, node });
        }
        if self.setup.new_fibers_every_step {
            self.contact.set_options(self.setup.options_at(next.step)).map_err(DynamicsError::Setup)?;
        }
        let evaluation = self.actors().evaluate(&next.displacement, next.step, time)?;
        next.acceleration.clone_from(&evaluation.acceleration);
        next.kick(self.step_size);
        if damped {
            next.decay(decay, &self.mass);
        }
        (self.state, self.evaluation) = (next, evaluation);
        let mut sample = self.sample();
        sample.warnings.extend(self.check_step()?);
        sample.contact_seconds = self.evaluation.contact_seconds;
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
        let Evaluation { strain, external, contact, .. } = &self.evaluation;
        let kinetic = self.state.kinetic(&self.mass);
        let forces = |resultants: &[fmc_contact::contact::Resultant<D>]| resultants.iter().map(|r| r.force).collect();
        let (bodies, obstacles): (Vec<[f64; D]>, Vec<[f64; D]>) = (forces(&contact.bodies), forces(&contact.obstacles));
        let sum = |axis: usize| bodies.iter().chain(&obstacles).map(|f| f[axis]).sum::<f64>();
        Sample {
            step: self.state.step,
            time: self.time(),
            kinetic,
            strain: *strain,
            contact: contact.energy,
            external: *external,
            total: kinetic + strain + contact.energy + external,
            dissipated: self.state.dissipated,
            balance: (0..D).map(|axis| sum(axis).powi(2)).sum::<f64>().sqrt(),
            bodies,
            obstacles,
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

    /// Mass of a part.
    pub fn part_mass(&self, part: usize) -> f64 {
        self.mass[self.setup.model.nodes_of(part)].iter().sum()
    }

    /// Time.
    pub fn time(&self) -> f64 {
        self.state.step as f64 * self.step_size
    }

    /// Step.
    pub fn step_size(&self) -> f64 {
        self.step_size
    }

    /// The stable step at the start, and what makes it.
    pub fn limit(&self) -> StepLimit {
        self.limit
    }

    /// Displacements, velocities and accelerations.
    pub fn state(&self) -> &State<D> {
        &self.state
    }

    /// The bodies.
    pub fn model(&self) -> &Model<D> {
        &self.setup.model
    }

    /// The contact, to look at its fibers for example.
    pub fn contact(&self) -> &Contact<D> {
        &self.contact
    }

    /// Contact forces at the current state.
    pub fn contact_forces(&self) -> &ContactForces<D> {
        &self.evaluation.contact
    }

    /// Mass of every node.
    pub fn mass(&self) -> &[f64] {
        &self.mass
    }

    /// Coordinates of the deformed bodies.
    pub fn coords(&self) -> Vec<[f64; D]> {
        placed(self.setup.model.coords(), &self.state.displacement)
    }

    /// Turns the motion round: the steps that follow lead back to where it came from.
    pub fn reverse(&mut self) {
        self.state.velocity.iter_mut().flatten().for_each(|v| *v = -*v);
    }

    fn actors(&self) -> Actors<'_, D> {
        let Self { setup, contact, inverse_mass, .. } = self;
        Actors { model: &setup.model, contact, load: &setup.load, inverse_mass }
    }

    fn stiffness(&self) -> Stiffness<'_, D> {
        let Self { setup, contact, mass, inverse_mass, .. } = self;
        Stiffness { model: &setup.model, contact, mass, inverse_mass }
    }
}
