//! Steps to the equilibrium of the contact with bodies that are linear, by a host that condenses them.

use crate::contact::equilibrium::descent::shortened;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{dot, moved};
use crate::contact::equilibrium::driver::progress::balance::Verdict;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;

/// Residual of a condensed step by that of the equilibrium: what it leaves is not to be seen.
pub(crate) const FINER: f64 = 0.1;

/// Part of the residual that a condensed step may leave where bodies are not linear: to them it is no equilibrium anyway.
const LEFT: f64 = 1e-2;

/// Iterations that are taken whole where there is no energy.
const WHOLE: usize = 8;

/// Steps, at most.
const MOST: usize = 30;

/// Trials along a step, at most.
const TRIALS: usize = 30;

/// The equilibrium, or `None` where this way does not lead there.
pub(crate) async fn levels<const D: usize>(
    search: &mut Search<D>,
    start: &[f64],
) -> Result<Option<(State<D>, Verdict)>, Trouble> {
    search.balance.again();
    let mut state = State::at(&search.host, start.to_vec(), true).await?;
    let still = vec![0.0; state.x.len()];
    for tried in 0..=MOST {
        let verdict;
        (state, verdict) = search.judged(state).await?;
        if verdict != Verdict::Not {
            return Ok(Some((state, verdict)));
        }
        if tried == MOST || !search.may_go_on() {
            return Ok(None);
        }
        let enough = if tried == 0 { 0.0 } else { LEFT.min(search.balance.relative()) * state.norm(&search.host) };
        let tolerances = [FINER * search.options.tolerance, enough];
        let condensed = search.host.condensed(&state.x, &state.inside, &still, tolerances).await;
        let Ok((step, is_definite)) = condensed else { return Ok(None) };
        let Ok(most) = search.allowed(&state.x, &step).await else { return Ok(None) };
        let next = match is_definite && !search.has_friction {
            true => least_energy(search, &state, &step, most).await?,
            false if tried < WHOLE => State::at(&search.host, moved(&state.x, most, &step), true).await.ok(),
            false => least_residual(search, &state, &step, most).await?,
        };
        match next {
            Some(next) => state = next,
            None => return Ok(None),
        }
    }
    Ok(None)
}

/// The state after a part of a step that lowers the energy.
async fn least_energy<const D: usize>(
    search: &Search<D>,
    state: &State<D>,
    step: &[f64],
    most: f64,
) -> Result<Option<State<D>>, Trouble> {
    let slope_of = |state: &State<D>| dot(&search.host.unknowns.freed(state.residual.clone()), step);
    let (slope, mut part) = (slope_of(state), most);
    if slope >= 0.0 {
        return Ok(None);
    }
    for _ in 0..TRIALS {
        let next = match State::at(&search.host, moved(&state.x, part, step), true).await {
            Ok(next) => next,
            Err(Trouble::Contact(_) | Trouble::Host(_)) => {
                part *= 0.5;
                continue;
            }
            Err(other) => return Err(other),
        };
        let (here, there) = state.descents(&search.host, &next, &moved(&next.x, -1.0, &state.x));
        if here.is_lowered_by(part, slope, &there) {
            return Ok(Some(next));
        }
        part = shortened(part, slope, slope_of(&next));
    }
    Ok(None)
}

/// The state after a part of a step that lowers the residual; where none does, after all of it.
async fn least_residual<const D: usize>(
    search: &Search<D>,
    state: &State<D>,
    step: &[f64],
    most: f64,
) -> Result<Option<State<D>>, Trouble> {
    let (norm, mut part) = (state.norm(&search.host), most);
    for _ in 0..WHOLE {
        if let Ok(next) = State::at(&search.host, moved(&state.x, part, step), true).await
            && next.norm(&search.host) < norm
        {
            return Ok(Some(next));
        }
        part *= 0.5;
    }
    Ok(State::at(&search.host, moved(&state.x, most, step), true).await.ok())
}
