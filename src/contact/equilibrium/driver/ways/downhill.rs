//! Down the energy, by steps that a part of the diagonal keeps short, with friction frozen as long as it is far from the end.

use super::along::along;
use crate::contact::equilibrium::driver::asking::host::System;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{dot, largest, moved};
use crate::contact::equilibrium::driver::progress::balance::Verdict;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::friction::Duals;
use crate::contact::tangents::TangentPart;

/// Steps, at most.
const MOST: usize = 60;

/// Steps after which bodies that rub have come this near, residual by the forces, or take smaller parts of the load step.
const LOST: usize = 25;
const FAR: f64 = 0.1;

/// Trials along a step, at most, and along one with the friction of now: where so little of it leads nearer, it leads nowhere.
const TRIALS: usize = 12;
const TRIALS_CURRENT: usize = 7;

/// Least and largest part of the diagonal.
const SHIFTS: [f64; 2] = [1e-9, 1e-2];

/// Residual by the forces below which the full tangent comes first, and the same while friction is frozen: the semidefinite one has then the
/// stiffness of all that has slid from its start to here, whose steps are neither too long nor in need of being made shorter. It leads near the
/// end in few steps, and not to it.
const FULL_BELOW: f64 = 0.1;
const FULL_BELOW_FROZEN: f64 = 1e-2;

/// Residual by the forces below which friction has the pressure of now.
const CURRENT_BELOW: f64 = 0.05;

/// A residual of which less than this part is left comes nearer.
const NEARER: f64 = 0.9;

/// Frozen steps, one after the other, of each of which more than this part of the residual is left: bodies creep to where they stick.
const CREEPING: usize = 2;
const CREEPS: f64 = 0.7;

/// Steps, one after the other, that come no nearer by any measure: as many are then as if bodies crept.
const IN_CIRCLES: usize = 6;

/// Steps with frozen friction after one with that of now has led nowhere.
const FROZEN: usize = 3;

/// From a place on.
pub(crate) async fn downhill<const D: usize>(
    search: &mut Search<D>,
    start: &[f64],
) -> Result<(State<D>, Verdict), Trouble> {
    search.begin_attempt();
    let mut state = State::at(&search.host, start.to_vec(), true).await?;
    let mut shift = first_shift(search, &state);
    let (mut trail, mut frozen_for) = (Vec::new(), 0usize);
    let (mut nearest, mut since) = (f64::INFINITY, 0);
    let (mut duals, mut creeping) = (Duals::default(), 0);
    for tried in 0..=MOST {
        let verdict;
        (state, verdict) = search.judged(state).await?;
        if verdict != Verdict::Not {
            return Ok((state, verdict));
        }
        trail.push(state.x.clone());
        let is_lost = search.has_friction && tried == LOST && nearest > FAR;
        if is_lost || tried == MOST || !search.may_go_on() {
            break;
        }
        let is_near = search.balance.relative() < CURRENT_BELOW && frozen_for == 0;
        let is_current = search.has_friction && !search.options.is_lagged && is_near;
        let is_frozen = search.has_friction && !is_current;
        let is_creeping = creeping >= CREEPING || since / IN_CIRCLES % 2 == 1;
        if is_frozen {
            state = search.frozen_at(state, &mut duals, is_creeping).await?;
        }
        let stepped = match is_frozen && is_creeping {
            true => to_the_least(search, &state, &mut shift).await,
            false => step(search, &state, &mut shift, is_current).await,
        };
        if is_frozen {
            search.host.contact(|contact| contact.release_friction()).await;
        }
        frozen_for = frozen_for.saturating_sub(1);
        let relative = search.balance.relative();
        (nearest, since) = if relative < NEARER * nearest { (relative, 0) } else { (nearest, since + 1) };
        match stepped? {
            Some(Stepped { x, left }) => {
                if is_frozen {
                    creeping = if left > CREEPS { creeping + 1 } else { 0 };
                }
                state = State::at(&search.host, x, true).await?;
            }
            None => frozen_for = FROZEN,
        }
    }
    Err(exhausted(search, &trail, &state))
}

/// A load as large as all of it moves a free body by a tenth of its thickness.
fn first_shift<const D: usize>(search: &Search<D>, state: &State<D>) -> f64 {
    let motions = &search.motions;
    let all = motions.magnitudes(&state.inside) + motions.magnitudes(&state.forces);
    let worst = all.iter().zip(&motions.diagonal).map(|(load, k)| load / k).fold(0.0, f64::max);
    (worst / (0.1 * search.assembly.thinnest())).clamp(SHIFTS[0], SHIFTS[1])
}

/// A direction with a tangent of which the energy falls, and its slope.
async fn direction<const D: usize>(
    search: &Search<D>,
    state: &State<D>,
    shift: f64,
    is_current: bool,
) -> Result<(Vec<f64>, f64), Trouble> {
    let mut parts = [TangentPart::Semidefinite, TangentPart::Full];
    let full_below = if search.has_friction { FULL_BELOW_FROZEN } else { FULL_BELOW };
    if is_current || search.balance.relative() < full_below {
        parts.reverse();
    }
    let (mut found, mut why) = (None, String::new());
    for part in parts {
        if found.is_some() && !search.may_go_on() {
            break;
        }
        let system = System { x: &state.x, part, shift };
        let right = state.residual.iter().map(|force| -force).collect();
        let step = match search.host.solve(system, right).await {
            Ok(step) => step,
            Err(trouble) => {
                why = trouble.to_string();
                continue;
            }
        };
        let slope = dot(&search.host.unknowns.freed(state.residual.clone()), &step);
        found = Some((step, slope));
        if slope < 0.0 || is_current {
            break;
        }
    }
    found.ok_or_else(|| Trouble::Hopeless(format!("{why}: is every body supported?")))
}

/// Where a step has led, and the part of the residual that is left.
struct Stepped {
    x: Vec<f64>,
    left: f64,
}

/// A step as far as the energy falls along it.
async fn to_the_least<const D: usize>(
    search: &Search<D>,
    state: &State<D>,
    shift: &mut f64,
) -> Result<Option<Stepped>, Trouble> {
    let (step, slope) = direction(search, state, *shift, false).await?;
    let most = search.allowed(&state.x, &step).await?;
    let (next, part) = along(search, state, (&step, slope), most).await?;
    let left = next.norm(&search.host) / state.norm(&search.host);
    *shift = next_shift(*shift, part / most, left);
    Ok(Some(Stepped { x: next.x, left }))
}

/// The part of the diagonal after a step of which this part was taken.
fn next_shift(shift: f64, part: f64, left: f64) -> f64 {
    match part {
        part if part >= 1.0 && left < 1.0 => (0.1 * shift).max(SHIFTS[0]),
        part if part > 0.1 => shift,
        _ => (10.0 * shift).min(SHIFTS[1]),
    }
}

/// Where a step leads; `None` where one with the friction of now leads nowhere.
async fn step<const D: usize>(
    search: &Search<D>,
    state: &State<D>,
    shift: &mut f64,
    is_current: bool,
) -> Result<Option<Stepped>, Trouble> {
    let norm = state.norm(&search.host);
    let (step, slope) = direction(search, state, *shift, is_current).await?;
    let most = search.allowed(&state.x, &step).await?;
    let (mut part, mut last, mut why) = (most, None, String::new());
    let trials = if is_current { TRIALS_CURRENT } else { TRIALS };
    for _ in 0..trials {
        let next = match State::at(&search.host, moved(&state.x, part, &step), false).await {
            Ok(next) => next,
            Err(trouble @ (Trouble::Contact(_) | Trouble::Host(_))) => {
                (part, why) = (0.5 * part, trouble.to_string());
                continue;
            }
            Err(other) => return Err(other),
        };
        let there = next.norm(&search.host);
        let is_better = if is_current {
            there < norm
        } else {
            let (here, ahead) = state.descents(&search.host, &next, &moved(&next.x, -1.0, &state.x));
            here.is_lowered_by(part, slope, &ahead) || there < 0.5 * norm
        };
        if is_better {
            let left = there / norm;
            *shift = next_shift(*shift, part / most, left);
            return Ok(Some(Stepped { x: next.x, left }));
        }
        last = Some(Stepped { x: next.x, left: there / norm });
        part *= 0.5;
    }
    if is_current {
        return Ok(None);
    }
    *shift = (10.0 * *shift).min(SHIFTS[1]);
    last.map(Some).ok_or_else(|| Trouble::Failed(format!("bodies cannot be evaluated along any part of a step: {why}")))
}

/// What has gone further than a part of a facet in the second half of the iterations is not held.
fn exhausted<const D: usize>(search: &Search<D>, trail: &[Vec<f64>], state: &State<D>) -> Trouble {
    let (last, middle) = (&trail[trail.len() - 1], &trail[trail.len() / 2]);
    let way = moved(last, -1.0, middle);
    let mover = search.assembly.mover(&search.host.unknowns.spread(&way));
    match mover.filter(|mover| largest(&way) > 0.1 * search.assembly.finest() && mover.way > 0.0) {
        Some(mover) if !search.motions.is_empty() => {
            // What slides is turned and pressed in on its way too: it is driven where its load is not balanced.
            let driven = search.host.unknowns.freed(moved(&vec![0.0; way.len()], -1.0, &state.residual));
            Trouble::adrift(&mover.driven(&search.assembly, &search.host.unknowns.spread(&driven)))
        }
        _ => {
            let (left, solves) = (search.balance.relative(), search.host.solves());
            Trouble::Failed(format!("the residual is {left:.1e} of the forces after {solves} linear solves"))
        }
    }
}
