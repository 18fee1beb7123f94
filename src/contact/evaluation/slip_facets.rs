//! Facets on which friction acts, with their sliders.

use super::parts::Contact;
use super::points::Points;
use super::sliding::{check_ready, sliding};
use super::walk::for_each_pair;
use crate::Error;
use crate::contact::friction::SlipFacets;
use crate::contact::laws::Asked;

/// All facets on which friction acts, by pair.
pub(super) fn slip_facets_in<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
) -> Result<Vec<SlipFacets<D>>, Error> {
    check_ready(contact)?;
    let asked = Asked { slides: true, ..Asked::default() };
    for_each_pair(contact, coords, |measured| {
        let Some(sliding) = sliding(contact, coords, measured)? else { return Ok(None) };
        let answer = measured.law.measure(measured, &asked)?;
        answer.map(|answer| SlipFacets::new(measured, &sliding, &answer.points)).transpose()
    })
}
