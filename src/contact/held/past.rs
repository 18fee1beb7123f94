//! What interfaces that have a history are asked with: what they have been through, the friction of the pair, and how long the step takes.

use crate::Error;
use crate::contact::method::Options;
use crate::contact::partners::Partners;
use crate::interfaces::{BrokenFriction, Cohesion, Cohesive, CohesiveLaw, LawFields, PointState};
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// What points have been through, by pair of bodies; nothing where a pair is not there.
pub(crate) type Damage = BTreeMap<[usize; 2], Vec<PointState>>;

/// The same of laws of the host, whose points have each so many numbers.
pub(crate) type LawHistory = BTreeMap<[usize; 2], Vec<f64>>;

/// The same for all interfaces of a contact.
#[derive(Clone, Copy)]
pub(crate) struct Past<'a, const D: usize> {
    pub(crate) damage: &'a Damage,
    pub(crate) of_laws: &'a LawHistory,
    pub(crate) law_fields: &'a LawFields,
    /// 0: none was said.
    pub(crate) time_step: f64,
    pub(crate) partners: &'a Partners<D>,
    pub(crate) options: &'a Options,
}

impl<'a, const D: usize> Past<'a, D> {
    /// What points have been through.
    pub(crate) fn states(&self, cohesion: &Cohesion<D>) -> &'a [PointState] {
        self.damage.get(&cohesion.bodies).map_or(&[], Vec::as_slice)
    }

    /// The law of an interface in this step.
    ///
    /// # Errors
    /// [`Error::Unsupported`] with a viscosity, where no time step was set.
    pub(crate) fn law(&self, options: &Cohesive, bodies: [usize; 2]) -> Result<CohesiveLaw, Error> {
        if options.viscosity > 0.0 && self.time_step <= 0.0 {
            let what = "a viscosity of a cohesive interface without a time step: set it before the evaluation (fmc_context_set_time_step, \
                        cohesive.set_time_step in Python, Contact::set_time_step in Rust)";
            return Err(Error::Unsupported { what });
        }
        let friction = self.partners.friction_of(&bodies.map(Partner::Body), self.options);
        let (coefficient, shear_limit) = (friction.coefficient, friction.shear_limit);
        let friction = (coefficient > 0.0).then_some(BrokenFriction { coefficient, shear_limit });
        Ok(CohesiveLaw::new(options).in_time(options.viscosity, self.time_step).rubbing(friction))
    }
}
