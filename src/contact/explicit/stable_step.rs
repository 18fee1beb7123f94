//! What the contact allows an explicit host.

use crate::Error;
use crate::contact::evaluation::kernels;
use crate::contact::interface::Contact;

impl<const D: usize> Contact<D> {
    /// Largest time step of central differences (leapfrog) for the contact alone, 2/√λ, where λ is a bound of the
    /// largest eigenvalue of M⁻¹K: K is the full tangent at `coords` ([`Self::tangent`]), M are `masses`, one lumped
    /// mass per node. The step lies up to 3 % below its limit, and 6 % where other eigenvalues are negative and a hundred
    /// times as large. Obstacles are held; so is a node of infinite mass. Infinite where nothing touches.
    ///
    /// A host whose own limit is Δt_host is stable with the step 1/Δt² = 1/Δt_host² + 1/Δt_contact², since the largest
    /// eigenvalue of a sum of symmetric matrices is at most the sum of the largest. The limit is that of the motion
    /// linearised at `coords`: contact that begins within a step is not in it, nor is a force that jumps (law `volume`
    /// with exponent below 2).
    ///
    /// # Errors
    /// As [`Self::tangent`]; [`Error::Length`] for masses of another number than the nodes,
    /// [`Error::NotPositiveMass`] for a node that feels contact.
    pub fn stable_step(&self, coords: &[[f64; D]], masses: &[f64]) -> Result<f64, Error> {
        let expected = self.surface.unknown_count();
        if masses.len() != expected {
            return Err(Error::Length { array: "masses", expected, found: masses.len() });
        }
        kernels::stable_step(self, coords, masses)
    }
}
