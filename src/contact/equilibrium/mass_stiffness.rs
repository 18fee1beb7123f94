//! Stiffness of the contact for explicit hosts.

use super::driver::layers_of_masses;
use crate::Error;
use crate::contact::changes;
use crate::contact::evaluation::Contact;

impl<const D: usize> Contact<D> {
    /// Finds the stiffness of every pair without a law of its own from the nodes' `masses` and the largest time step, `limit`, that the
    /// bodies allow by themselves in central differences: with contact of whole faces the step becomes a tenth shorter. The law of the
    /// options has a stiffness of 0. Infinite masses are those of nodes that the host holds.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NotPositive`] for the limit, [`Error::NotPositiveMass`], [`Error::Unsupported`] where the host holds every
    /// surface, or where the options give a stiffness, which would count. What was found before then stays.
    #[inline(never)]
    pub fn stiffness_from_masses(&mut self, coords: &[[f64; D]], masses: &[f64], limit: f64) -> Result<(), Error> {
        if self.options().law.stiffness() > 0.0 {
            return Err(Error::Unsupported {
                what: "a stiffness from masses beside the option stiffness, which counts: set it to 0",
            });
        }
        let layers = layers_of_masses(self, coords, masses, limit)?;
        changes::options::set_layer_stiffness(self, Some(layers))
    }
}
