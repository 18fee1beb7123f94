//! All forces at one displacement.

use super::error::DynamicsError;
use crate::fem::Model;
use fmc_contact::{Contact, ContactForces};
use std::time::Instant;

/// Energies, contact forces and acceleration at one displacement.
pub(super) struct Evaluation<const D: usize> {
    pub(super) strain: f64,
    /// Potential of the dead loads, −Σ f·u.
    pub(super) external: f64,
    pub(super) contact: ContactForces<D>,
    /// M⁻¹ (external + contact − internal), `[node_count, D]`.
    pub(super) acceleration: Vec<[f64; D]>,
    pub(super) contact_seconds: f64,
}

/// What accelerates the nodes.
pub(super) struct Actors<'a, const D: usize> {
    pub(super) model: &'a Model<D>,
    pub(super) contact: &'a Contact<D>,
    /// Dead forces; empty for none.
    pub(super) load: &'a [[f64; D]],
    /// 1/m per degree of freedom, 0 where a support holds.
    pub(super) inverse_mass: &'a [[f64; D]],
}

impl<const D: usize> Actors<'_, D> {
    /// Evaluates the forces at `displacement`; `step` and `time` are for errors.
    pub(super) fn evaluate(
        &self,
        displacement: &[[f64; D]],
        step: u64,
        time: f64,
    ) -> Result<Evaluation<D>, DynamicsError> {
        // Internal forces first: their energy tells of inverted cells, which the contact would report in its own words.
        let mut acceleration = vec![[0.0; D]; displacement.len()];
        let strain = self.model.internal(displacement, &mut acceleration);
        if strain == f64::INFINITY {
            return Err(DynamicsError::InvertedCell { step, time });
        }
        let clock = Instant::now();
        let contact = self.contact.evaluate(&placed(self.model.coords(), displacement));
        let contact_seconds = clock.elapsed().as_secs_f64();
        let contact = contact.map_err(|error| DynamicsError::Contact { step, time, error })?;
        let mut external = 0.0;
        for (f, u) in self.load.iter().zip(displacement) {
            external -= f.iter().zip(u).map(|(f, u)| f * u).sum::<f64>();
        }
        for (node, a) in acceleration.iter_mut().enumerate() {
            for axis in 0..D {
                let load = self.load.get(node).map_or(0.0, |f| f[axis]);
                a[axis] = (load + contact.forces[node][axis] - a[axis]) * self.inverse_mass[node][axis];
            }
        }
        Ok(Evaluation { strain, external, contact, acceleration, contact_seconds })
    }
}

/// Coordinates of the deformed bodies, X + u.
pub(super) fn placed<const D: usize>(coords: &[[f64; D]], displacement: &[[f64; D]]) -> Vec<[f64; D]> {
    coords.iter().zip(displacement).map(|(x, u)| std::array::from_fn(|axis| x[axis] + u[axis])).collect()
}
