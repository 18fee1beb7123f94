//! What the laws answer for every pair, and what friction adds.

use super::bring::with_state;
use super::parts::Contact;
use super::points::Points;
use super::sliding::{check_ready, released, sliding, wearing_freely};
use super::walk::for_each_pair;
use crate::Error;
use crate::contact::friction::{SlipFacets, Tractions};
use crate::contact::laws::{Answer, Asked, Measured};
use crate::contact::results::add_rotation;
use crate::overlap::Partner;

/// What is asked of every pair, with its friction.
pub(super) fn measured_pairs<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
    asked: &Asked,
) -> Result<(Vec<Answer<D>>, Vec<Tractions<D>>), Error> {
    check_ready(contact)?;
    let rotations = asked.rotations.then_some(contact.partners.obstacles.count());
    let tractions_of = |facets: &SlipFacets<D>| {
        let tractions = Tractions::new(facets, coords.len(), asked.tangent, rotations);
        if asked.limited { tractions.with_limited(facets, coords.len()) } else { tractions }
    };
    let each = |work: &(dyn Fn(&Measured<D>) -> Result<Option<_>, Error> + Sync)| match asked.apart {
        true => with_state(contact, coords, |_| Ok(Vec::new())),
        false => for_each_pair(contact, coords, work),
    };
    let found = each(&|measured| {
        let slides = if contact.history.frozen.is_none() { sliding(contact, coords, measured)? } else { None };
        let wears = if slides.is_none() && asked.energy { wearing_freely(contact, coords, measured) } else { None };
        let (slides_here, wants_energy) = (slides.is_some() || wears.is_some(), asked.energy);
        let asked = Asked { slides: slides_here, energy: wants_energy || asked.rotations, ..*asked };
        let Some(mut answer) = measured.law.measure(measured, &asked)? else { return Ok(None) };
        if let Some(part) = asked.tangent.filter(|_| asked.rotations) {
            add_rotation(measured, &mut answer, part, contact.partners.obstacles.count())?;
            answer.energy = answer.energy.filter(|_| wants_energy);
        }
        let points = std::mem::take(&mut answer.points);
        let tractions = match (slides, wears) {
            (Some(sliding), _) => Some(tractions_of(&SlipFacets::new(measured, &sliding, &points)?)),
            (None, Some(free)) => Some(SlipFacets::new(measured, &free, &points)?.without_friction()),
            (None, None) => None,
        };
        Ok(Some((answer, tractions)))
    })?;
    let (mut answers, tractions): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    answers.extend(contact.answers_of_held(coords.unshifted, (asked.energy, asked.tangent))?);
    let mut tractions: Vec<_> = tractions.into_iter().flatten().collect();
    if asked.apart {
        return Ok((answers, tractions));
    }
    let frozen = contact.history.frozen_at(coords.unshifted, &contact.partners.obstacles.poses());
    tractions.extend(frozen.iter().map(tractions_of));
    let pairs: Vec<[Partner; 2]> = tractions.iter().map(|pair| pair.partners).collect();
    let gone = released(contact, &pairs)?;
    tractions.extend(gone.into_iter().map(|(pair, energy)| Tractions::released(pair, energy)));
    Ok((answers, tractions))
}
