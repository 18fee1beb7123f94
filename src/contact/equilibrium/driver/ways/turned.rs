//! Facets that would slide the other way than in the step before: they stick first.
//!
//! What slides has no stiffness along its way but that of the bodies, which is small beside that of what sticks. Where a facet slides that
//! sticks in the end, a step leads so far back that it slides the other way, and the next one as far again. Between the two it must have
//! stuck: a step in which it does, whatever its limit is, shows whether it stays so. This is the active set of a method in which tractions are
//! unknowns too, and facets change by what tractions a step asks for, not by how far they went.
//!
//! A body that friction alone holds is held by nothing where all of its facets slide. But where they slide two ways at once, as bodies spread,
//! one between the two does not.

use crate::Error;
use crate::contact::changes::friction_steps::{Slid, hold_turned};
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::progress::search::Search;

/// The facets of an iteration.
#[derive(Default)]
pub(crate) struct Turned<const D: usize> {
    slid: Slid<D>,
}

impl<const D: usize> Turned<D> {
    /// Holds those that have turned round, until friction is released; whether there is any.
    pub(crate) async fn held(&mut self, search: &Search<D>, x: &[f64]) -> Result<bool, Trouble> {
        let (coords, mut slid) = (search.host.unknowns.coords(x), std::mem::take(&mut self.slid));
        let is_loose = !search.motions.is_empty();
        let held = search.host.contact(move |contact| {
            let is_any = hold_turned(contact, &coords, &mut slid, is_loose)?;
            Ok::<_, Error>((slid, is_any))
        });
        let is_any;
        (self.slid, is_any) = held.await?;
        Ok(is_any)
    }
}
