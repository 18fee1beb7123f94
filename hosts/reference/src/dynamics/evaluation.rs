//! All forces at one displacement.

use super::error::DynamicsError;
use crate::fem::Model;
use fmc_contact::{Contact, ContactForces};
use std::time::Instant;

/// What the structure does at one displacement.
pub(super) struct Structure<const D: usize> {
    pub(super) strain: f64,
    /// Potential of the dead loads, −Σ f·u.
    pub(super) external: f64,
    /// M⁻¹ (external − internal), `[node_count, D]`.
    pub(super) acceleration: Vec<[f64; D]>,
}

/// What the contact does at one displacement.
pub(super) struct Touch<const D: usize> {
    pub(super) forces: ContactForces<D>,
    /// M⁻¹ contact, `[node_count, D]`.
    pub(super) acceleration: Vec<[f64; D]>,
    /// Seconds it took.
    pub(super) seconds: f64,
}

impl<const D: usize> Touch<D> {
    /// Sum of the forces on every body, then on every obstacle.
    pub(super) fn resultants(&self) -> Vec<[f64; D]> {
        self.forces.bodies.iter().chain(&self.forces.obstacles).map(|resultant| resultant.force).collect()
    }
}

/// What accelerates the nodes. `step` and `time` of a call are for errors.
pub(super) struct Actors<'a, const D: usize> {
    pub(super) model: &'a Model<D>,
    pub(super) contact: &'a Contact<D>,
    /// Dead forces; empty for none.
    pub(super) load: &'a [[f64; D]],
    /// 1/m per degree of freedom, 0 where a support holds.
    pub(super) inverse_mass: &'a [[f64; D]],
    pub(super) step: u64,
    pub(super) time: f64,
}

impl<const D: usize> Actors<'_, D> {
    pub(super) fn structure(&self, displacement: &[[f64; D]]) -> Result<Structure<D>, DynamicsError> {
        let mut acceleration = vec![[0.0; D]; displacement.len()];
        let strain = self.model.internal(displacement, &mut acceleration);
        if strain == f64::INFINITY {
            return Err(DynamicsError::InvertedCell { step: self.step, time: self.time, cell: None });
        }
        let mut external = 0.0;
        for (f, u) in self.load.iter().zip(displacement) {
            external -= f.iter().zip(u).map(|(f, u)| f * u).sum::<f64>();
        }
        for (node, a) in acceleration.iter_mut().enumerate() {
            for axis in 0..D {
                let load = self.load.get(node).map_or(0.0, |f| f[axis]);
                a[axis] = (load - a[axis]) * self.inverse_mass[node][axis];
            }
        }
        Ok(Structure { strain, external, acceleration })
    }

    pub(super) fn touch(&self, displacement: &[[f64; D]]) -> Result<Touch<D>, DynamicsError> {
        let clock = Instant::now();
        let forces = self.contact.evaluate(&placed(self.model.coords(), displacement));
        let seconds = clock.elapsed().as_secs_f64();
        let (step, time) = (self.step, self.time);
        let forces = forces.map_err(|error| match error {
            fmc_contact::Error::InvertedCell { cell } | fmc_contact::Error::FoldedCell { cell, .. } => {
                DynamicsError::InvertedCell { step, time, cell: Some(cell) }
            }
            error => DynamicsError::Contact { step, time, error },
        })?;
        let product = |(f, w): (&[f64; D], &[f64; D])| std::array::from_fn(|axis| f[axis] * w[axis]);
        let acceleration = forces.forces.iter().zip(self.inverse_mass).map(product).collect();
        Ok(Touch { forces, acceleration, seconds })
    }
}

/// Coordinates of the deformed bodies, X + u.
pub(super) fn placed<const D: usize>(coords: &[[f64; D]], displacement: &[[f64; D]]) -> Vec<[f64; D]> {
    coords.iter().zip(displacement).map(|(x, u)| std::array::from_fn(|axis| x[axis] + u[axis])).collect()
}

/// Sum of two nodal vectors.
pub(super) fn sum<const D: usize>(a: &[[f64; D]], b: &[[f64; D]]) -> Vec<[f64; D]> {
    a.iter().zip(b).map(|(a, b)| std::array::from_fn(|axis| a[axis] + b[axis])).collect()
}
