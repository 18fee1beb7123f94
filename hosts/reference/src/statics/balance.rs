//! Forces and energies of a state.

use super::equations::Equations;
use fmc_contact::ContactForces;

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
    /// Internal less contact and external force of every node; on what is held, the reaction, and on what is joined, that of what joins it.
    pub residual: Vec<[f64; D]>,
    /// Norm of the residual on what is not held.
    pub norm: f64,
    /// Largest of the norms of the internal, contact and external forces.
    pub scale: f64,
    /// What the contact had to say.
    pub contact: ContactForces<D>,
}

impl<const D: usize> Balance<D> {
    /// Total energy Π.
    pub fn energy(&self) -> f64 {
        self.strain + self.contact_energy + self.friction_energy - self.work
    }

    /// Residual by the forces; 0 where there are none.
    pub fn relative(&self) -> f64 {
        if self.norm == 0.0 { 0.0 } else { self.norm / self.scale }
    }

    pub(super) fn new(
        strain: f64,
        internal: Vec<[f64; D]>,
        contact: ContactForces<D>,
        load: impl Fn(usize) -> [f64; D],
        displacement: &[[f64; D]],
        equations: &Equations,
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
        let free = equations.gathered(&equations.led(residual.as_flattened().to_vec()));
        let norm = free.iter().map(|r| r * r).sum::<f64>().sqrt();
        let scale = squares.into_iter().fold(0.0, f64::max).sqrt();
        let friction_energy = contact.friction.stored + contact.friction.dissipated;
        let contact_energy = contact.energy;
        Self { strain, contact_energy, friction_energy, work, residual, norm, scale, contact }
    }
}
