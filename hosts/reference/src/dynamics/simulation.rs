//! Bodies in motion.

use super::checkpoint::Checkpoint;
use super::error::{CheckpointError, DynamicsError};
use super::evaluation::{Actors, Structure, Touch, placed, sum};
use super::fingerprint::fingerprint;
use super::friction_step::FrictionStep;
use super::setup::{Setup, Step};
use super::stable_step::Stiffness;
use super::state::State;
use super::step_limit::StepLimit;
use crate::fem::Model;
use fmc_contact::{Contact, ContactForces};
use std::path::Path;

/// Bodies in motion.
///
/// ```text
/// v(n+½) = v(n)   + ½ Δt a(n)          kick
/// u(n+1) = u(n)   +   Δt v(n+½)        drift
/// a(n+1) = M⁻¹ (f_external + f_contact(u(n+1)) − f_internal(u(n+1)))
/// v(n+1) = v(n+½) + ½ Δt a(n+1)        kick
/// ```
///
/// With several contact sub-steps ([`Setup::contact_substeps`]) the contact has a leapfrog of its own between the two
/// kicks of the structure (impulse multiple time stepping, Tuckerman, Berne and Martyna 1992), symplectic and
/// reversible as well. One sub-step is the scheme above.
///
/// Damping, where asked for, multiplies v by exp(−α Δt/2) before and after: its exact flow, so that it is stable for
/// any α and the scheme stays of second order.
pub struct Simulation<const D: usize> {
    pub(super) setup: Setup<D>,
    pub(super) contact: Contact<D>,
    pub(super) mass: Vec<f64>,
    pub(super) inverse_mass: Vec<[f64; D]>,
    pub(super) step_size: f64,
    pub(super) limit: StepLimit,
    pub(super) state: State<D>,
    /// Displacement at which the step of friction that leads to the state began; empty without friction.
    pub(super) step_start: Vec<[f64; D]>,
    pub(super) structure: Structure<D>,
    pub(super) touch: Touch<D>,
    /// Contact forces on bodies, then on obstacles: means over the sub-steps of the last step.
    pub(super) resultants: Vec<[f64; D]>,
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
        Self::at(setup, state, None, None)
    }

    /// Continues from a file that [`Self::save`] wrote: bit for bit as if there had been no interruption.
    ///
    /// # Errors
    /// [`DynamicsError::Checkpoint`] if the file is damaged, or belongs to another setup or another step; those of
    /// [`Self::start`].
    pub fn resume(setup: Setup<D>, path: &Path) -> Result<Self, DynamicsError> {
        let Checkpoint { fingerprint: found, step_size, state, friction } = Checkpoint::read(path)?;
        if found != fingerprint(&setup) || state.displacement.len() != setup.model.node_count() {
            return Err(CheckpointError::OtherModel.into());
        }
        match setup.step {
            Step::Fixed(asked) if asked != step_size => {
                Err(CheckpointError::OtherStep { found: step_size, asked }.into())
            }
            _ => Self::at(setup, state, Some(step_size), friction),
        }
    }

    /// Writes the state to a file, whole or not at all.
    ///
    /// # Errors
    /// [`CheckpointError::File`].
    pub fn save(&self, path: &Path) -> Result<(), CheckpointError> {
        let (fingerprint, step_size) = (fingerprint(&self.setup), self.step_size);
        Checkpoint { fingerprint, step_size, state: self.state.clone(), friction: self.friction_step() }.write(path)
    }

    fn at(
        setup: Setup<D>,
        mut state: State<D>,
        saved_step: Option<f64>,
        friction: Option<FrictionStep<D>>,
    ) -> Result<Self, DynamicsError> {
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
        let mut step_start = Vec::new();
        if setup.contact.friction.is_active() {
            let (begun, slip) = match friction {
                Some(FrictionStep { displacement, slip }) => (displacement, Some(slip)),
                None => (state.displacement.clone(), None),
            };
            contact.begin_step(&placed(setup.model.coords(), &begun)).map_err(DynamicsError::Setup)?;
            slip.map_or(Ok(()), |slip| contact.set_slip(&slip)).map_err(DynamicsError::Setup)?;
            step_start = begun;
        }
        let stiffness = Stiffness { model: &setup.model, contact: &contact, mass: &mass, inverse_mass: &inverse_mass };
        let (limit, step_size) = match (saved_step, setup.step) {
            (None, Step::Auto) => stiffness.auto()?,
            (None, Step::Fixed(asked)) => (stiffness.admits(asked, &state.displacement)?, asked),
            (Some(saved), _) => (stiffness.limit_before_contact(), saved),
        };
        let time = state.step as f64 * step_size;
        let (step, load) = (state.step, &setup.load);
        let actors = Actors { model: &setup.model, contact: &contact, load, inverse_mass: &inverse_mass, step, time };
        let (structure, touch) = (actors.structure(&state.displacement)?, actors.touch(&state.displacement)?);
        state.acceleration = sum(&structure.acceleration, &touch.acceleration);
        let resultants = touch.resultants();
        Ok(Self {
            setup,
            contact,
            mass,
            inverse_mass,
            step_size,
            limit,
            state,
            step_start,
            structure,
            touch,
            resultants,
        })
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
        &self.touch.forces
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

    pub(super) fn actors(&self, step: u64, time: f64) -> Actors<'_, D> {
        let Self { setup, contact, inverse_mass, .. } = self;
        Actors { model: &setup.model, contact, load: &setup.load, inverse_mass, step, time }
    }

    pub(super) fn stiffness(&self) -> Stiffness<'_, D> {
        let Self { setup, contact, mass, inverse_mass, .. } = self;
        Stiffness { model: &setup.model, contact, mass, inverse_mass }
    }
}
