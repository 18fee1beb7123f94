//! Multipliers of another load as a guess for this one.

use super::unchanged::found_there;
use super::unloaded::is_gone;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{dot, norm};
use crate::contact::equilibrium::driver::bodies::elastic::deformed;
use crate::contact::equilibrium::driver::progress::falling::Falling;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;

/// Part of the forces that has to be out of balance where a step begins, for loads to have changed.
const CHANGED: f64 = 1e-2;

/// Lets multipliers fall with the load where a step begins: those of a load that is gone would press and pull on bodies that nothing else
/// holds. The load was K u less the forces of the equilibrium where the step begins, those of the bodies in the last one that was found, or else
/// those of the contact, and is K u less the internal forces now; what is left of it is its part along what it was. An obstacle that has moved
/// changes no load. Updates find what is wrong with this guess. An end without load has no forces to measure
/// residuals by: those of the equilibrium where the step begins do. Where all forces are what coordinates are rounded to, nothing is left of
/// the load for which the multipliers were.
pub(crate) async fn falling_load<const D: usize>(search: &mut Search<D>, start: State<D>) -> Result<State<D>, Trouble> {
    let host = &search.host;
    search.unloaded = is_gone(search, &start).await?;
    let has_any = host.contact(|contact| {
        !contact.history.multipliers.is_empty() || contact.ties.have_multipliers() || contact.glides.have_multipliers()
    });
    let has_any = has_any.await;
    if start.norm(host) <= CHANGED * norm(&start.forces) {
        // What presses hardly does so for the load that changes.
        search.unloaded = None;
        return Ok(start);
    }
    if !(has_any || search.has_friction) {
        return Ok(start);
    }
    let rounding = search.balance.rounding(host, &search.assembly, &start).await?;
    if start.scale(&rounding.of_coordinates) == 0.0 {
        return if has_any { let_go(host, start, 0.0).await } else { Ok(start) };
    }
    let (displaced, _) = deformed(host, &start.x).await?;
    let bodies = host.product(displaced, false).await?;
    let load = |forces: &[f64]| -> Vec<f64> {
        host.unknowns.freed(bodies.iter().zip(forces).map(|(bodies, force)| bodies - force).collect())
    };
    let last = found_there(search, &start).await;
    let was_found = last.is_some();
    let (before, now) = (load(last.as_ref().unwrap_or(&start.forces)), load(&start.inside));
    let change: Vec<f64> = before.iter().zip(&now).map(|(before, now)| now - before).collect();
    if norm(&change) <= CHANGED * norm(&start.forces) {
        search.unloaded = None;
        return Ok(start);
    }
    search.balance.measured_by(norm(&host.unknowns.freed(bodies.clone())).min(norm(&start.forces)));
    search.updates.fall_from(&start.contact);
    let part = dot(&now, &before) / dot(&before, &before);
    // One that turns has all that it was along its old way, but for rounding. Where there was hardly any, this one is new.
    let is_new = norm(&before) <= CHANGED * norm(&now);
    if is_new || !(part.is_finite() && part < 1.0 + CHANGED) {
        return Ok(start);
    }
    let part = part.clamp(0.0, 1.0);
    // Whether forces where the step begins were those of a load that is gone or has turned is known after an equilibrium alone.
    if search.has_friction && (part > 0.0 || was_found) {
        let (forces, before) = (norm(&start.forces), search.host.contact(|contact| contact.all_multipliers()).await);
        search.falling = Some(Falling { part, forces, before });
    }
    if !has_any || part > 1.0 - CHANGED {
        return Ok(start);
    }
    let_go(&search.host, start, part).await
}

/// The start with a part of the multipliers.
async fn let_go<const D: usize>(host: &Host<D>, start: State<D>, part: f64) -> Result<State<D>, Trouble> {
    host.contact(move |contact| contact.scale_multipliers(part)).await;
    start.again(host).await
}
