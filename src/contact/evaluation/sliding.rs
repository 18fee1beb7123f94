//! How pairs slide.

use super::parts::Contact;
use crate::Error;
use crate::contact::friction::{Sliding, Stick};
use crate::contact::laws::Measured;

/// Refuses a law without a stiffness, and friction before a step has begun.
pub(crate) fn check_ready<const D: usize>(contact: &Contact<D>) -> Result<(), Error> {
    contact.partners.check_stiffness(contact.method.options())?;
    let has_friction = contact.partners.has_friction(contact.method.options());
    if has_friction && contact.history.step.is_none() { Err(Error::NoStep) } else { Ok(()) }
}

/// How a pair slides, `None` for one without friction.
pub(crate) fn sliding<'a, const D: usize>(
    contact: &'a Contact<D>,
    measured: &Measured<D>,
) -> Result<Option<Sliding<'a, D>>, Error> {
    let Contact { mesh, partners, method, history, .. } = contact;
    let friction = partners.friction_of(&measured.pair.partners, method.options());
    let Some(step) = history.step.as_ref().filter(|_| friction.is_active()) else { return Ok(None) };
    let what = "friction with a law that has no stiffness of its own: set the friction's";
    let stick = match friction.memoryless_slip {
        Some(slip) => Stick::Memoryless(slip),
        None => {
            Stick::Spring(friction.stiffness.or(measured.law.initial_stiffness()).ok_or(Error::Unsupported { what })?)
        }
    };
    let now = partners.bearing_rule(&measured.pair.partners, method.options(), mesh.hashes());
    let bearings = history.bearings.as_ref().and_then(|bearings| bearings.of(&measured.pair.partners, now));
    Ok(Some(Sliding { friction, stick, step, bearings }))
}
