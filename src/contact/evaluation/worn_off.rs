//! What sliding wears off in a step.

use super::parts::Contact;
use super::points::Points;
use super::sliding::{check_ready, gone, wear_of_step, wearing};
use super::walk::for_each_pair;
use crate::Error;
use crate::contact::friction::{SlipFacets, Tractions};
use crate::contact::laws::Asked;
use crate::contact::wear::WornOff;
use crate::overlap::Warning;

/// Told of a pair that would wear off more in this step than its sides penetrate: what presses with k times the penetration g is left with
/// g (1 − K k |s|), which must not change its sign.
pub(super) fn large_wear<const D: usize>(contact: &Contact<D>, tractions: &Tractions<D>) -> Option<Warning> {
    let Contact { partners, method, history, .. } = contact;
    let [a, b] = tractions.partners;
    let coefficients = partners.table.wear(&[a, b])?;
    let stiffness = partners.stiffness_of(&[a, b], method.options());
    let slid = history.wear_cycles * tractions.totals.largest_slip;
    let ratio = coefficients.iter().sum::<f64>() * stiffness * slid;
    (ratio > 1.0).then_some(Warning::LargeWear { a, b, ratio })
}

/// By pair, facet and point of the mesh, each as often as points of contact lie there.
pub(super) fn worn_off_in<const D: usize>(contact: &Contact<D>, coords: &Points<D>) -> Result<Vec<WornOff>, Error> {
    check_ready(contact)?;
    let by_pair = for_each_pair(contact, coords, |measured| {
        let Some((sliding, coefficients)) = wearing(contact, coords, measured)? else { return Ok(None) };
        let asked = Asked { slides: true, ..Asked::default() };
        let Some(answer) = measured.law.measure(measured, &asked)? else { return Ok(None) };
        let facets = SlipFacets::new(measured, &sliding, &answer.points)?;
        let mut found = Vec::new();
        facets.worn_off((measured.pair, &sliding), &answer.points, coefficients, |facet, point, volume| {
            found.push(WornOff { facet, point, volume });
        });
        Ok(Some((measured.pair.partners, found)))
    })?;
    let (pairs, mut found): (Vec<_>, Vec<_>) = by_pair.into_iter().unzip();
    for (pair, sliding) in gone(contact, &pairs)? {
        let Some(coefficients) = wear_of_step(contact, &pair) else { continue };
        let mut of_pair = Vec::new();
        sliding.worn_off_before((pair, &contact.mesh.surface), coefficients, |facet, point, volume| {
            of_pair.push(WornOff { facet, point, volume });
        });
        found.push(of_pair);
    }
    Ok(found.into_iter().flatten().collect())
}
