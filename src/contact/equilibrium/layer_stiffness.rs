//! Stiffness of the contact from that of the bodies.

use crate::Error;
use crate::contact::changes;
use crate::contact::evaluation::Contact;
use crate::contact::partners::LayerStiffness;
use crate::overlap::Partner;

impl<const D: usize> Contact<D> {
    /// Sets how stiff the layers of cells below the surfaces are, `None`: forgets it. Where the law of the options has a stiffness of 0,
    /// each pair without a law of its own has then the one that suits the softer of its two layers.
    ///
    /// # Errors
    /// [`Error::Length`] for another number of bodies, [`Error::NotPositive`], [`Error::BodyOutOfRange`],
    /// [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`]. What was set before then stays.
    pub fn set_layer_stiffness(&mut self, stiffness: Option<LayerStiffness>) -> Result<(), Error> {
        changes::options::set_layer_stiffness(self, stiffness)
    }

    /// Stiffness k of the law that a pair follows, pressure by penetration; 0 where there is none yet.
    pub(crate) fn stiffness_of_pair(&self, mut pair: [Partner; 2]) -> f64 {
        pair.sort_unstable();
        self.partners.law_of(&pair, &self.method).initial_stiffness().unwrap_or(0.0)
    }

    /// The largest that any pair has.
    pub(crate) fn largest_stiffness(&self) -> f64 {
        self.partners.laws(&self.method).filter_map(|law| law.initial_stiffness()).fold(0.0, f64::max)
    }

    /// Whether any pair has friction.
    pub fn has_friction(&self) -> bool {
        self.partners.has_friction(self.method.options())
    }

    /// What was set.
    pub fn layer_stiffness(&self) -> Option<&LayerStiffness> {
        self.partners.layer_stiffness()
    }
}
