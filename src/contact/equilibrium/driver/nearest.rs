//! The equilibrium beside the start, stable or not: Newton's method with the full tangent and whole steps, as far as none is too long.

use super::balance::Verdict;
use super::host::System;
use super::search::Search;
use super::secant::Secant;
use super::state::State;
use super::trouble::Trouble;
use super::unknowns::moved;
use crate::contact::tangents::TangentPart;

/// Steps, at most.
const MOST: usize = 16;

/// Times running that the residual may stay above its smallest; with friction facets take turns to stick and to slide first.
const ABOVE: usize = 2;
const ABOVE_WITH_FRICTION: usize = 4;

/// Part of the diagonal that holds what nothing else holds.
const SHIFT: f64 = 1e-12;

/// Residual by the forces above which surfaces are not where they will press.
const FAR: f64 = 0.1;

/// Residual by the forces below which facets stay as they are, and what a step has shown holds for the next.
const SETTLED: f64 = 1e-4;

/// Part of a step below which it leads nowhere.
const SHORTEST: f64 = 1e-3;

/// The equilibrium, or `None` where it does not come nearer.
pub(super) async fn nearest<const D: usize>(
    search: &mut Search<D>,
    start: &[f64],
) -> Result<Option<(State<D>, Verdict)>, Trouble> {
    let begun = search.balance.history.len();
    if let Some(found) = by_whole_steps(search, start, false).await? {
        return Ok(Some(found));
    }
    // Where it came near and stayed there, the first step has led past a kink.
    let was_near = search.balance.history[begun..].iter().any(|relative| *relative <= FAR);
    if search.has_friction || !was_near { Ok(None) } else { by_whole_steps(search, start, true).await }
}

/// By whole steps with the full tangent; with a stiff start the first one, if it is far from the end, with the semidefinite tangent: the full
/// one takes pressed surfaces for softer than they are, and may lead nodes past one another.
async fn by_whole_steps<const D: usize>(
    search: &mut Search<D>,
    start: &[f64],
    is_stiff: bool,
) -> Result<Option<(State<D>, Verdict)>, Trouble> {
    search.begin_attempt();
    let mut state = State::at(&search.host, start.to_vec(), true).await?;
    let (mut secant, mut counted) = (search.has_friction.then(Secant::default), search.updates.count);
    let (mut least, mut above, mut updates) = (f64::INFINITY, 0, search.updates.count);
    let most_above = if search.has_friction { ABOVE_WITH_FRICTION } else { ABOVE };
    for tried in 0..=MOST {
        let verdict;
        (state, verdict) = search.judged(state).await?;
        if verdict != Verdict::Not {
            return Ok(Some((state, verdict)));
        }
        let norm = state.norm(&search.host);
        if search.updates.count > updates {
            (least, updates) = (f64::INFINITY, search.updates.count);
        }
        above = if norm > least { above + 1 } else { 0 };
        least = least.min(norm);
        if tried == MOST || above > most_above || !search.may_go_on() {
            return Ok(None);
        }
        let shift = if search.motions.is_empty() { 0.0 } else { SHIFT };
        let is_far = is_stiff && tried == 0 && search.balance.relative() > FAR;
        let part = if is_far { TangentPart::Semidefinite } else { TangentPart::Full };
        let system = System { x: &state.x, part, shift };
        let right = state.residual.iter().map(|force| -force).collect();
        let Ok(mut step) = search.host.solve(system, right).await else { return Ok(None) };
        if let Some(secant) = &mut secant {
            step = secant.corrected(step, search.updates.count == counted && search.balance.relative() < SETTLED);
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
