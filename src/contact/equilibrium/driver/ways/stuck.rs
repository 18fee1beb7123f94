//! The first step where a load falls: all that rubs sticks.
//!
//! A load that falls takes the limits of friction with it, and what surfaces carried is beyond them before anything has moved. A step with
//! the tangent of what slides would let bodies spring back as if friction hardly held them, far beyond where it turns round. But bodies that
//! spring back slide against what carried them along, and so first give back what is elastic: the step of facets that stick leads there,
//! and shows which of them slide, and which way.

use crate::contact::changes::friction_steps::hold;
use crate::contact::equilibrium::driver::asking::host::System;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{moved, norm};
use crate::contact::equilibrium::driver::progress::falling::Falling;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::evaluation::Contact;
use crate::contact::tangents::TangentPart;

/// Part of the diagonal that holds what nothing else holds.
const SHIFT: f64 = 1e-12;

/// Part of the multipliers' change from which the change of the forces is found: so little that nothing parts.
const LITTLE: f64 = 1e-6;

/// Part of the forces above which bodies are wedged where they are after a step in which nothing slides, whatever is left of the load, and
/// residual by these forces below which they may balance there: bodies that part press hardly by then, or drive one another apart.
const WEDGED: f64 = 2e-3;
const BALANCE: f64 = 1.1;

/// Where bodies go if nothing slides or parts.
pub(crate) struct Stuck {
    pub(crate) x: Vec<f64>,
    /// Whether they press one another there.
    pub(crate) is_wedged: bool,
}

/// Where bodies go if nothing slides or parts; `None` where that is not known, or where something is in the way.
pub(crate) async fn stuck<const D: usize>(
    search: &mut Search<D>,
    x: &[f64],
    falling: Falling<D>,
) -> Result<Option<Stuck>, Trouble> {
    let coords = search.host.unknowns.coords(x);
    let put_back = |contact: &mut Contact<D>, multipliers| {
        let now = contact.all_multipliers();
        contact.put_back_multipliers(multipliers);
        now
    };
    let Falling { part, forces, before } = falling;
    let (now, is_held) =
        search.host.contact(move |contact| (put_back(contact, before), hold(contact, &coords).is_ok())).await;
    let step = if is_held { held_step(search, x, part).await } else { Ok(None) };
    search
        .host
        .contact(move |contact| {
            contact.release_friction();
            contact.put_back_multipliers(now);
        })
        .await;
    let Some(step) = step? else { return Ok(None) };
    let Ok(allowed) = search.allowed(x, &step).await else { return Ok(None) };
    if allowed < 1.0 {
        return Ok(None);
    }
    let x = moved(x, 1.0, &step);
    let is_wedged = match State::at(&search.host, x.clone(), false).await {
        Ok(state) => {
            let there = norm(&state.forces);
            there > WEDGED * forces && state.norm(&search.host) < BALANCE * there
        }
        Err(Trouble::Contact(_) | Trouble::Host(_)) => false,
        Err(other) => return Err(other),
    };
    Ok(Some(Stuck { x, is_wedged }))
}

/// The step of the contact as it is, with what the multipliers press with falling to a part.
async fn held_step<const D: usize>(search: &Search<D>, x: &[f64], part: f64) -> Result<Option<Vec<f64>>, Trouble> {
    let host = &search.host;
    let state = State::at(host, x.to_vec(), true).await?;
    let (residual, coords) = (state.residual, host.unknowns.coords(x));
    let with_less = host.contact(move |contact| {
        let before = contact.all_multipliers();
        contact.scale_multipliers(1.0 - LITTLE * (1.0 - part));
        let found = contact.evaluate(&coords);
        contact.put_back_multipliers(before);
        found
    });
    let less = host.unknowns.gather(&with_less.await?.forces);
    let right = (0..x.len()).map(|k| (less[k] - state.forces[k]) / LITTLE - residual[k]).collect();
    let shift = if search.motions.is_empty() { 0.0 } else { SHIFT };
    let system = System { x, part: TangentPart::Full, shift };
    Ok(host.solve(system, right).await.ok())
}
