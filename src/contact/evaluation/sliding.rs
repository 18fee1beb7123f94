//! How pairs slide.

use super::parts::Contact;
use super::points::Points;
use crate::Error;
use crate::contact::friction::{Friction, OwnLimit, Sliding, Step, Stick};
use crate::contact::laws::{Measured, PairLaw};
use crate::overlap::Partner;

/// Refuses a law without a stiffness, and friction before a step has begun.
pub(crate) fn check_ready<const D: usize>(contact: &Contact<D>) -> Result<(), Error> {
    contact.check_stiffness()?;
    let has_friction = contact.partners.has_friction(contact.method.options());
    if has_friction && contact.history.step.is_none() { Err(Error::NoStep) } else { Ok(()) }
}

/// How a pair slides, `None` for one without friction.
pub(super) fn sliding<'a, const D: usize>(
    contact: &'a Contact<D>,
    coords: &'a Points<D>,
    measured: &Measured<D>,
) -> Result<Option<Sliding<'a, D>>, Error> {
    let sliding = sliding_of(contact, &measured.pair.partners, measured.law)?;
    Ok(sliding.map(|sliding| Sliding { material: coords.material(), ..sliding }))
}

/// How a pair slides of which a side wears, freely where it has no friction, and what its sides wear by, all cycles of the step together;
/// `None` where neither does.
pub(super) fn wearing<'a, const D: usize>(
    contact: &'a Contact<D>,
    coords: &'a Points<D>,
    measured: &Measured<D>,
) -> Result<Option<(Sliding<'a, D>, [f64; 2])>, Error> {
    let Some(coefficients) = wear_of_step(contact, &measured.pair.partners) else { return Ok(None) };
    let sliding = match sliding(contact, coords, measured)? {
        Some(sliding) => sliding,
        None => free(contact.history.step_of(&measured.pair.partners).ok_or(Error::NoStep)?, coords),
    };
    Ok(Some((sliding, coefficients)))
}

/// What the sides of a pair wear by, all cycles of the step together; `None` where neither does.
pub(super) fn wear_of_step<const D: usize>(contact: &Contact<D>, pair: &[Partner; 2]) -> Option<[f64; 2]> {
    let coefficients = contact.partners.table.wear(pair)?;
    Some(coefficients.map(|coefficient| coefficient * contact.history.wear_cycles))
}

/// How a pair slides of which a side wears, and that has no friction, once a step has begun.
pub(super) fn wearing_freely<'a, const D: usize>(
    contact: &'a Contact<D>,
    coords: &'a Points<D>,
    measured: &Measured<D>,
) -> Option<Sliding<'a, D>> {
    let Contact { partners, method, history, .. } = contact;
    let pair = &measured.pair.partners;
    let wears = partners.table.wear(pair).is_some() && !partners.friction_of(pair, method.options()).is_active();
    history.step_of(pair).filter(|_| wears).map(|step| free(step, coords))
}

/// All of the slip of what nothing holds is slid, whatever the slip from which friction without memory would act in full.
fn free<'a, const D: usize>(step: &'a Step<D>, coords: &'a Points<D>) -> Sliding<'a, D> {
    Sliding {
        friction: Friction::coulomb(1.0),
        orthotropy: None,
        stick: Stick::Memoryless(1.0),
        step,
        material: coords.material(),
        bearings: None,
        is_by_depth: false,
        stiffer: 1.0,
        pulled: 1.0,
        sticking: 1.0,
        own: None,
    }
}

/// The same of a pair that follows this law.
fn sliding_of<'a, const D: usize>(
    contact: &'a Contact<D>,
    pair: &[Partner; 2],
    law: &dyn PairLaw<D>,
) -> Result<Option<Sliding<'a, D>>, Error> {
    let Contact { mesh, partners, method, history, .. } = contact;
    let friction = partners.friction_of(pair, method.options());
    let Some(step) = history.step_of(pair).filter(|_| friction.is_active()) else { return Ok(None) };
    let what = "friction with a law without a stiffness: set the stiffness of friction";
    let stick = match friction.memoryless_slip {
        Some(slip) => Stick::Memoryless(slip / history.sticking.max(f64::MIN_POSITIVE.sqrt())),
        None => {
            let stiffness = friction.stiffness.or(law.initial_stiffness()).ok_or(Error::Unsupported { what })?;
            Stick::Spring(history.sticking * stiffness)
        }
    };
    let now = partners.bearing_rule(pair, method.options(), mesh.hashes());
    let bearings = history.bearings.as_ref().and_then(|bearings| bearings.of(pair, now));
    let is_by_depth = law.initial_stiffness().is_some();
    let stiffness = partners.stiffness_of(pair, method.options());
    let since = history.bearings.as_ref().filter(|_| is_by_depth);
    let [stiffer, kept] = since.map_or([1.0; 2], |begun| begun.stiffer(pair, stiffness, history.stiffened));
    let pulled = if friction.has_stiffness_of_law() { kept / stiffer } else { 1.0 };
    let orthotropy = partners.orthotropy_of(pair, method.options());
    let (time_step, fields, sticking) = (history.time_step, &history.law_fields, history.sticking);
    let own = partners.friction_law(pair).map(|own| OwnLimit { own, time_step, fields });
    let material = None;
    Ok(Some(Sliding {
        friction,
        orthotropy,
        stick,
        step,
        material,
        bearings,
        is_by_depth,
        stiffer,
        pulled,
        sticking,
        own,
    }))
}

/// The pairs that were in contact when the step began and are not any more, with how each slid; `found` are those that
/// are.
pub(super) fn gone<'a, const D: usize>(
    contact: &'a Contact<D>,
    found: &[[Partner; 2]],
) -> Result<Vec<([Partner; 2], Sliding<'a, D>)>, Error> {
    let Contact { partners, method, history, .. } = contact;
    let Some(step) = &history.step else { return Ok(Vec::new()) };
    let mut pairs: Vec<[Partner; 2]> = step.slip.keys().map(|(pair, ..)| *pair).collect();
    pairs.dedup();
    pairs.retain(|pair| !found.contains(pair) && partners.has(pair, method.options()));
    let sliding = |pair: [Partner; 2]| {
        Ok(sliding_of(contact, &pair, partners.law_of(&pair, method))?.map(|sliding| (pair, sliding)))
    };
    pairs.into_iter().filter_map(|pair| sliding(pair).transpose()).collect()
}

/// The same with the energy that was stored in them.
pub(crate) fn released<const D: usize>(
    contact: &Contact<D>,
    found: &[[Partner; 2]],
) -> Result<Vec<([Partner; 2], f64)>, Error> {
    let energy =
        |(pair, sliding): ([Partner; 2], Sliding<D>)| (pair, sliding.bore(pair).map(|(.., energy)| energy).sum());
    Ok(gone(contact, found)?.into_iter().map(energy).collect())
}
