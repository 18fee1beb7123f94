//! What hosts ask of friction that follows a law of theirs.

use crate::Error;
use crate::contact::changes;
use crate::contact::evaluation::Contact;
use crate::contact::friction::{FrictionLaw, OwnFriction};
use crate::contact::partners::PairOptions;
use crate::overlap::Partner;
use std::sync::Arc;

impl<const D: usize> Contact<D> {
    /// Sets the options of a pair as [`Self::set_pair_options`] does, with [`PairOptions::friction_law`], and the law by which it slides. What the
    /// law keeps begins with zeros, unless it is the very law that the pair has.
    ///
    /// # Errors
    /// Those of [`Self::set_pair_options`]; [`Error::Unsupported`] beside a coefficient of friction or a wear coefficient of the pair, another
    /// interface than contact, and for a mesh in parts. What was set before then stays.
    #[inline(never)]
    pub fn set_friction_law_pair(
        &mut self,
        partners: [Partner; 2],
        options: PairOptions,
        law: Arc<dyn FrictionLaw>,
    ) -> Result<(), Error> {
        let options = PairOptions { friction_law: true, ..options };
        changes::options::set_pair(self, partners, Some(options), (None, Some(OwnFriction::new(law))))
    }

    /// What laws of friction keep after the steps that were accepted ([`Self::commit_step`]): for each row of [`Self::slip`], in its order, as many
    /// numbers as the law of the pair has, none without a law. With the slip it is all that a restart needs of them.
    ///
    /// # Errors
    /// [`Error::NoStep`].
    #[inline(never)]
    pub fn friction_history(&self) -> Result<Vec<f64>, Error> {
        changes::friction_steps::friction_history(self)
    }

    /// Sets it, after [`Self::set_slip`] with the rows that it belongs to; frozen friction is released.
    ///
    /// # Errors
    /// [`Error::NoStep`], [`Error::Length`], [`Error::BadEntry`] for what is not finite. Nothing has then changed.
    #[inline(never)]
    pub fn set_friction_history(&mut self, history: &[f64]) -> Result<(), Error> {
        changes::friction_steps::set_friction_history(self, history)
    }
}
