//! Forces and energies of a state.

use super::noise::Noise;
use crate::fem::Constraints;
use fmc_contact::ContactForces;
use fmc_contact::contact::equilibrium::descent::Descent;

/// Energies of a displacement, and what they miss to balance.
#[derive(Clone, Debug)]
pub struct Balance<const D: usize> {
    /// Strain energy.
    pub strain: f64,
    /// Contact energy.
    pub contact_energy: f64,
    /// Energy that friction has stored and dissipated since the load step began. Frozen friction has it as its potential.
    pub friction_energy: f64,
    /// Work of the loads.
    pub work: f64,
    /// Internal less contact and external force of every node; on what is held, the reaction.
    pub residual: Vec<[f64; D]>,
    /// Norm of the residual on what is not held.
    pub norm: f64,
    /// Largest of the norms of the internal, contact and external forces.
    pub scale: f64,
    /// What rounding of the displacement calls up; a residual below it is none.
    pub(super) noise: Noise,
    /// What the contact had to say.
    pub contact: ContactForces<D>,
}

impl<const D: usize> Balance<D> {
    /// Total energy Π.
    pub fn energy(&self) -> f64 {
        self.strain + self.contact_energy + self.friction_energy - self.work
    }

    /// Residual by the forces; 0 where there are none. A body that is free of stress after it was moved has forces of rounding
    /// alone, and by themselves these would never balance.
    pub fn relative(&self) -> f64 {
        if self.norm <= self.noise.force { 0.0 } else { self.norm / self.scale }
    }

    /// As far as the rules of a descent go.
    pub(super) fn descent(&self) -> Descent {
        let flat = Descent::flatness(self.magnitude()) + self.noise.energy;
        Descent { energy: self.energy(), norm: self.norm, rounding: self.rounding(), flat }
    }

    /// What rounding may change in the energy.
    pub(super) fn rounding(&self) -> f64 {
        64.0 * f64::EPSILON * self.magnitude() + self.noise.energy
    }

    /// Sum of the energies' magnitudes.
    pub(super) fn magnitude(&self) -> f64 {
        self.strain + self.contact_energy.abs() + self.friction_energy + self.work.abs()
    }

    pub(super) fn new(
        strain: f64,
        internal: Vec<[f64; D]>,
        contact: ContactForces<D>,
        load: impl Fn(usize) -> [f64; D],
        displacement: &[[f64; D]],
        supports: &Constraints<D>,
    ) -> Self {
        let (mut work, mut squares) = (0.0, [0.0; 3]);
        let mut residual = internal;
        for (node, r) in residual.iter_mut().enumerate() {
            let (external, touch) = (load(node), contact.forces[node]);
            for axis in 0..D {
                work += external[axis] * displacement[node][axis];
                let forces = [r[axis], touch[axis], external[axis]];
                (0..3).for_each(|k| squares[k] += forces[k] * forces[k]);
                r[axis] -= touch[axis] + external[axis];
            }
        }
        let mut free = residual.clone();
        supports.clear(&mut free);
        let norm = free.iter().flatten().map(|r| r * r).sum::<f64>().sqrt();
        let scale = squares.into_iter().fold(0.0, f64::max).sqrt();
        let friction_energy = contact.friction.stored + contact.friction.dissipated;
        let (contact_energy, noise) = (contact.energy, Noise::default());
        Self { strain, contact_energy, friction_energy, work, residual, norm, scale, noise, contact }
    }

    /// Slope of the energy along a direction that moves nothing held.
    pub(super) fn slope(&self, direction: &[[f64; D]]) -> f64 {
        self.residual.iter().flatten().zip(direction.iter().flatten()).map(|(r, d)| r * d).sum()
    }
}
