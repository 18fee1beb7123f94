//! The equilibrium beside the start, stable or not: Newton's method with the full tangent and whole steps, as far as none is too long.

use super::secant::Secant;
use super::turned::Turned;
use crate::contact::equilibrium::driver::asking::host::System;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::moved;
use crate::contact::equilibrium::driver::progress::balance::Verdict;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::tangents::TangentPart;

/// Steps, at most; as many more as long as the residual was at its smallest within the last two: what comes nearer is not begun anew.
const MOST: usize = 16;
const SINCE: usize = 1;

/// Times running that the residual may stay above its smallest; with friction facets take turns to stick and to slide first.
const ABOVE: usize = 2;
const ABOVE_WITH_FRICTION: usize = 4;

/// Part of the diagonal that holds what nothing else holds.
const SHIFT: f64 = 1e-12;

/// Residual by the forces above which surfaces are not where they will press.
const FAR: f64 = 0.1;

/// Residual by the forces below which facets stay as they are, and what a step has shown holds for the next; the same after softer friction.
const SETTLED: f64 = 1e-4;
const SETTLED_HARDENED: f64 = 1e-2;

/// Part of a step below which it leads nowhere.
const SHORTEST: f64 = 1e-3;

/// How the steps begin.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Begin {
    /// As they go on.
    Full,
    /// With the semidefinite tangent.
    Stiff,
    /// After one in which all that rubs stuck: facets that turn round stick first.
    Stuck,
    /// As they go on, where softer friction has led to.
    Hardened,
}

/// Where the steps end.
#[derive(Clone, Copy)]
pub(crate) enum Enough {
    /// In equilibrium.
    Balanced,
    /// At this residual by the forces, without moving surfaces out, where it is not above its smallest as many times running.
    Roughly(f64, usize),
}

/// The equilibrium, or `None` where it does not come nearer.
pub(crate) async fn nearest<const D: usize>(
    search: &mut Search<D>,
    start: &[f64],
    begin: Begin,
) -> Result<Option<(State<D>, Verdict)>, Trouble> {
    let begun = search.balance.history.len();
    if let Some(found) = by_whole_steps(search, start, begin, Enough::Balanced).await? {
        return Ok(Some(found));
    }
    // Where it came near and stayed there, the first step has led past a kink.
    let was_near = search.balance.history[begun..].iter().any(|relative| *relative <= FAR);
    if search.has_friction || !was_near {
        Ok(None)
    } else {
        by_whole_steps(search, start, Begin::Stiff, Enough::Balanced).await
    }
}

/// By whole steps with the full tangent; where they begin stiff the first one, if it is far from the end, with the semidefinite tangent: the full
/// one takes pressed surfaces for softer than they are, and may lead nodes past one another.
pub(crate) async fn by_whole_steps<const D: usize>(
    search: &mut Search<D>,
    start: &[f64],
    begin: Begin,
    enough: Enough,
) -> Result<Option<(State<D>, Verdict)>, Trouble> {
    search.begin_attempt();
    let mut state = State::at(&search.host, start.to_vec(), true).await?;
    let (mut secant, mut counted) = (search.has_friction.then(Secant::default), search.updates.count);
    let mut turned = Turned::default();
    let settled = if begin == Begin::Hardened { SETTLED_HARDENED } else { SETTLED };
    let (mut least, mut above, mut updates) = (f64::INFINITY, 0, search.updates.count);
    let most_above = match enough {
        Enough::Roughly(_, above) => above,
        Enough::Balanced if search.has_friction => ABOVE_WITH_FRICTION,
        Enough::Balanced => ABOVE,
    };
    for tried in 0..=2 * MOST {
        let verdict;
        (state, verdict) = match enough {
            Enough::Roughly(enough, _) => search.roughly_judged(state, enough).await?,
            Enough::Balanced => search.judged(state).await?,
        };
        if verdict != Verdict::Not {
            return Ok(Some((state, verdict)));
        }
        let norm = state.norm(&search.host);
        if search.updates.count > updates {
            (least, updates) = (f64::INFINITY, search.updates.count);
        }
        above = if norm > least { above + 1 } else { 0 };
        least = least.min(norm);
        let is_over = tried == 2 * MOST || (tried >= MOST && above > SINCE);
        if is_over || above > most_above || !search.may_go_on() {
            return Ok(None);
        }
        let shift = if search.motions.is_empty() { 0.0 } else { SHIFT };
        let is_far = begin == Begin::Stiff && tried == 0 && search.balance.relative() > FAR;
        let part = if is_far { TangentPart::Semidefinite } else { TangentPart::Full };
        let system = System { x: &state.x, part, shift };
        let is_turned = begin == Begin::Stuck && turned.held(search, &state.x).await?;
        let Ok(mut step) = solved(search, &state, system, is_turned).await else { return Ok(None) };
        if let Some(secant) = &mut secant {
            let is_settled = search.balance.relative() < settled && !is_turned;
            step = secant.corrected(step, search.updates.count == counted && is_settled);
        }
        counted = search.updates.count;
        let Ok(part) = search.allowed(&state.x, &step).await else { return Ok(None) };
        if part < SHORTEST {
            return Ok(None);
        }
        match State::at(&search.host, moved(&state.x, part, &step), true).await {
            Ok(next) => {
                if let Some(secant) = &mut secant {
                    secant.taken(part, step);
                }
                state = next;
            }
            Err(Trouble::Contact(_) | Trouble::Host(_)) => return Ok(None),
            Err(other) => return Err(other),
        }
    }
    Ok(None)
}

/// The step, where some facets are held by what they would carry if they stuck; friction is then released.
async fn solved<const D: usize>(
    search: &Search<D>,
    state: &State<D>,
    system: System<'_>,
    is_held: bool,
) -> Result<Vec<f64>, Trouble> {
    let negative = |residual: &[f64]| residual.iter().map(|force| -force).collect();
    if !is_held {
        return search.host.solve(system, negative(&state.residual)).await;
    }
    let found = match State::at(&search.host, state.x.clone(), true).await {
        Ok(held) => search.host.solve(system, negative(&held.residual)).await,
        Err(trouble) => Err(trouble),
    };
    search.host.contact(|contact| contact.release_friction()).await;
    found
}
