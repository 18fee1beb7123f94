//! What is said where forces are hardly more than what coordinates are rounded to.

use crate::contact::equilibrium::driver::asking::unknowns::norm;
use crate::contact::equilibrium::driver::progress::balance::Verdict;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::equilibrium::driver::progress::within_facets::UNLOADED;

/// Part of the forces that rounding may change, at the worst, before it is told: it changes a twentieth of that as a rule.
const MATTERS: f64 = 1e-2;

/// Part of the rounding from which on forces may be a load: those of a host that finds strains from coordinates are less without one.
const A_LOAD: f64 = 0.02;

/// What rounding does to the forces of an equilibrium, where it is much: k times the rounding of coordinates is a pressure.
pub(crate) async fn rounded<const D: usize>(search: &Search<D>, state: &State<D>, verdict: Verdict) -> Option<String> {
    let [lost, unseen] = search.balance.rounded();
    let load = norm(&state.inside);
    let remedy = "move the model nearer to the origin, or set a lower stiffness";
    if verdict == Verdict::Rounded && search.balance.relative() == 0.0 && load > A_LOAD * unseen {
        return Some(format!(
            "forces of {load:.1e} count as none: coordinates are rounded, which at the stiffness of bodies and contact is {unseen:.1e}; {remedy}"
        ));
    }
    let forces = load.max(norm(&state.forces)).max(search.balance.at_start());
    // Where a load is gone, forces are what rounding leaves of it.
    let before = search.host.contact(|contact| contact.history.last.as_ref().map_or(0.0, |last| last.scale)).await;
    if forces <= UNLOADED * before {
        return None;
    }
    // Forces that are all rounding are those of bodies without a load.
    (state.contact.contact_area > 0.0 && lost > MATTERS * forces && lost < forces).then(|| {
        let part = 100.0 * lost / forces;
        format!("forces may be wrong by up to {part:.0} %: coordinates are rounded, which at the stiffness of the contact is {lost:.1e}; {remedy}")
    })
}
