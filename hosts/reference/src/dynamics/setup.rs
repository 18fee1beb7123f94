//! What a simulation is started from.

use super::error::DynamicsError;
use crate::fem::{Constraints, Model, Part};
use fmc_contact::{Estimator, Obstacle, Options};

/// The step of a simulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// 0.9 of the stable step at the start, see [`super::StepLimit`].
    Auto,
    /// This one; refused if it exceeds the stable step at the start.
    Fixed(f64),
}

/// Bodies, what holds and drives them, and how they touch. Arrays are `[node_count, D]`.
pub struct Setup<const D: usize> {
    /// The bodies.
    pub model: Model<D>,
    /// Energy law and estimator of the contact.
    pub contact: Options,
    /// Rigid partners; they do not move.
    pub obstacles: Vec<Obstacle<D>>,
    /// Degrees of freedom that are held at a displacement, from the start.
    pub supports: Constraints<D>,
    /// Dead forces on the nodes, constant in time; empty for none.
    pub load: Vec<[f64; D]>,
    /// Initial velocity; empty for bodies at rest.
    pub velocity: Vec<[f64; D]>,
    /// Step.
    pub step: Step,
    /// Rate α of the mass-proportional damping force −α M v, 1/time; 0 for none.
    pub damping: f64,
    /// Evaluations of the contact in every step, at least 1 (the paper's scheme). More of them resolve a force that jumps,
    /// at the cost of contact alone: on the star with m = 1, which gains 4 % of energy, four leave 0.6 %. In contact the
    /// energy swings a little more, by what is done between two evaluations of the structure. The stable step is that of
    /// one evaluation.
    pub contact_substeps: u32,
    /// Lay new fibers at every step, as the paper does (Algorithm 1). Off by default: fibers that stay where they are
    /// have an energy, new ones do work at random.
    pub new_fibers_every_step: bool,
    /// Steps between two checks of the stable step during the run, 0 for none. A check costs about as
    /// much as a step or two.
    pub check_every: u64,
}

impl<const D: usize> Setup<D> {
    /// Bodies at rest, free and without loads, with the stable step, checked every 200 steps.
    pub fn new(model: Model<D>, contact: Options) -> Self {
        Self {
            model,
            contact,
            obstacles: Vec::new(),
            supports: Constraints::default(),
            load: Vec::new(),
            velocity: Vec::new(),
            step: Step::Auto,
            damping: 0.0,
            contact_substeps: 1,
            new_fibers_every_step: false,
            check_every: 200,
        }
    }

    /// Checks values and lengths.
    pub(super) fn check(&self) -> Result<(), DynamicsError> {
        let is_straight = |part: &&Part<D>| part.cell_type == part.cell_type.straight();
        if let Some(part) = self.model.parts().iter().find(|part| !is_straight(part)) {
            return Err(DynamicsError::SecondOrder { part: part.name.clone() });
        }
        let expected = self.model.node_count();
        for (array, values) in [("load", &self.load), ("velocity", &self.velocity)] {
            if !values.is_empty() && values.len() != expected {
                return Err(DynamicsError::Length { array, expected, found: values.len() });
            }
            if let Some(&value) = values.iter().flatten().find(|x| !x.is_finite()) {
                return Err(DynamicsError::Value { name: array, value });
            }
        }
        match self.step {
            Step::Fixed(value) if !(value.is_finite() && value > 0.0) => {
                return Err(DynamicsError::Value { name: "step", value });
            }
            _ => {}
        }
        if !(self.damping.is_finite() && self.damping >= 0.0) {
            return Err(DynamicsError::Value { name: "damping", value: self.damping });
        }
        match self.supports.iter().find(|(node, ..)| *node >= expected) {
            Some((node, ..)) => Err(DynamicsError::Support { node }),
            None => Ok(()),
        }
    }

    /// The contact's options at a step: with other fibers at every step, if those are asked for.
    pub(super) fn options_at(&self, step: u64) -> Options {
        let mut options = self.contact;
        if let (Estimator::Fibers(fibers), true) = (&mut options.estimator, self.new_fibers_every_step) {
            // An odd constant with mixed bits: the seeds of one run are not those of its neighbour one step later.
            fibers.seed = fibers.seed.wrapping_add(step.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        }
        options
    }
}
