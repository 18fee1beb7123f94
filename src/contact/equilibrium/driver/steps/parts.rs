//! A load step in one part, or, where that fails, in several.

use super::attempt::{LoadStep, Reached, balanced, equilibrium};
use super::first_touch::{first_of_all, first_touches};
use crate::Error;
use crate::contact::equilibrium::driver::asking::host::System;
use crate::contact::equilibrium::driver::asking::outcome::Found;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{largest, moved};
use crate::contact::equilibrium::driver::bodies::motions::Motions;
use crate::contact::equilibrium::driver::progress::balance::Verdict;
use crate::contact::equilibrium::driver::progress::before::Before;
use crate::contact::equilibrium::driver::progress::breaking::breaking;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::equilibrium::driver::progress::within_facets::within_facets;
use crate::contact::equilibrium::driver::told::half_turns::half_turns;
use crate::contact::equilibrium::driver::told::held::held;
use crate::contact::equilibrium::driver::told::held_apart::held_apart;
use crate::contact::equilibrium::driver::told::locking::locking;
use crate::contact::equilibrium::driver::told::overlaps::overlaps;
use crate::contact::equilibrium::driver::told::passed::passed;
use crate::contact::equilibrium::driver::told::rounded::rounded;
use crate::contact::equilibrium::driver::told::standing::standing;
use crate::contact::equilibrium::driver::ways::falling_load::falling_load;
use crate::contact::equilibrium::driver::ways::levels::FINER;
use crate::contact::equilibrium::driver::ways::unchanged::{kept, taken_up};
use crate::contact::results::PairForces;
use crate::contact::tangents::TangentPart;
use crate::overlap::Partner;

/// Smallest part of a load step.
const SMALLEST: f64 = 1.0 / 64.0;

/// The same where a state is in doubt.
const SMALLEST_OF_DOUBT: f64 = 1.0 / 8.0;

/// Penetration by a facet of either body from which on a state is in doubt.
const DOUBTFUL: f64 = 0.25;

/// Times that a step of what is prescribed is halved, where it turns a cell inside out.
const HALVINGS: usize = 8;

/// Residual by the forces at the end of a step that is an equilibrium of linear bodies.
const IN_ORDER: f64 = 1e-3;

/// Part of the diagonal that holds loose bodies while what is prescribed moves.
const SHIFT: f64 = 1e-9;

/// What is said where nothing is found with slip that counts from there.
const STRAIGHT: &str = "bodies that were apart touch in this step, and no equilibrium was found with slip counted from where they touch: it counts \
    as if they had come there straight from the start of the step; end a step where they touch";

/// How often something was done, and what was in the way.
#[derive(Default)]
struct Counts {
    parts: usize,
    rigid_steps: usize,
    /// Why what is prescribed last went no farther.
    trouble: Option<String>,
}

/// All of a load step.
pub(crate) async fn in_parts<const D: usize>(search: &mut Search<D>, step: &LoadStep<D>) -> Result<Found<D>, Trouble> {
    let start = State::at(&search.host, step.x.clone(), true).await?;
    search.balance.begin(&search.host, &search.assembly, &start).await?;
    passed(search, &step.x).await?;
    for text in half_turns(search).await {
        search.warn(text);
    }
    overlaps(search, &start).await?;
    taken_up(search, &start, &step.moved).await;
    let start = falling_load(search, start).await?;
    let (mut x, mut done, mut part, mut counts) = (step.x.clone(), 0.0, 1.0, Counts::default());
    let (mut adrift, mut is_straight) = (None, false);
    let mut is_at_touch = match first_of_all(search, step, &start).await? {
        Some(touching) => {
            x = touching;
            true
        }
        None => false,
    };
    loop {
        let until = if done + part > 1.0 - 1e-9 { 1.0 } else { done + part };
        // What did not balance at the start is taken off little by little.
        search.host.set_offset(start.residual.iter().map(|force| (1.0 - until) * force).collect());
        let target = moved(&step.x, until, &step.moved);
        let before = search.host.contact(|contact| Before::of(contact)).await;
        let told = search.warnings.len();
        match led(search, &x, (&target, until == 1.0), &mut counts).await {
            Ok(reached)
                if part > SMALLEST_OF_DOUBT && search.may_go_on() && !doubtful(search, &reached).await.is_empty() =>
            {
                part *= 0.5;
                search.warnings.truncate(told);
                search.host.contact(|contact| before.put_back(contact)).await;
            }
            Ok(reached) if until == 1.0 => {
                let before = (done == 0.0).then_some(before);
                let reached = from_first_touch(search, reached, (&target, before), &mut counts).await?;
                let is_none = search.host.contact(|contact| contact.history.first_touches.are_none()).await;
                if is_straight && is_none && reached.state.contact.contact_area > 0.0 {
                    search.warn(STRAIGHT.to_owned());
                }
                return finished(search, reached, &counts).await;
            }
            Ok(reached) => {
                is_at_touch = false;
                (x, done) = (reached.state.x, until);
                part = (2.0 * part).min(1.0 - done);
            }
            Err(_) if is_at_touch => {
                // From where the step began, with slip that counts straight until something is found.
                (x, is_at_touch, is_straight) = (step.x.clone(), false, true);
                search.warnings.truncate(told);
                search.host.contact(|contact| before.without_first_touches().put_back(contact)).await;
            }
            Err(trouble @ (Trouble::Unheld(..) | Trouble::Hopeless(_))) => return Err(trouble),
            // Of what went wrong, that a body came to no rest says most.
            Err(trouble) if part <= SMALLEST || !search.may_go_on() => return Err(adrift.unwrap_or(trouble)),
            Err(trouble) => {
                counts.trouble = Some(trouble.to_string());
                if adrift.is_none() && matches!(trouble, Trouble::Adrift(..)) {
                    adrift = Some(trouble);
                }
                part *= 0.5;
                search.warnings.truncate(told);
                search.host.contact(|contact| before.put_back(contact)).await;
            }
        }
    }
}

/// Pairs in a state that may be an equilibrium that nobody looks for, with a corner through what it stands on: a stiffness from the bodies lets
/// them penetrate by a small part of a facet, and corners that are deeper than they are thick are pushed back by less, not by more.
async fn doubtful<const D: usize>(search: &Search<D>, reached: &Reached<D>) -> Vec<String> {
    let assembly = &search.assembly;
    if !search.host.contact(|contact| contact.layer_stiffness().is_some()).await {
        return Vec::new();
    }
    let facet = |partner: Partner| match partner {
        Partner::Body(body) => assembly.facet_size[body],
        Partner::Obstacle(_) => 0.0,
    };
    let said = |pair: &PairForces| {
        let (deep, facet) = (pair.penetration, facet(pair.a).max(facet(pair.b)));
        (deep > DOUBTFUL * facet).then(|| {
            format!(
                "{} and {} penetrate by {deep:.1e}, {:.0} % of a facet: a corner may have passed through the other \
                 surface; take smaller load steps, or refine there",
                assembly.name(pair.a),
                assembly.name(pair.b),
                100.0 * deep / facet
            )
        })
    };
    reached.state.contact.pairs.iter().filter_map(said).collect()
}

/// The equilibrium with unknowns that are not free at their targets, from x; whether it is the last of the step.
async fn led<const D: usize>(
    search: &mut Search<D>,
    x: &[f64],
    (target, is_last): (&[f64], bool),
    counts: &mut Counts,
) -> Result<Reached<D>, Trouble> {
    let mut x = x.to_vec();
    loop {
        counts.parts += 1;
        let free = &search.host.unknowns.free;
        let way: Vec<f64> = (0..x.len()).map(|k| if free[k] { 0.0 } else { target[k] - x[k] }).collect();
        let part = if largest(&way) == 0.0 { 1.0 } else { carried(search, &mut x, &way, counts).await? };
        search.updates.begin(search.has_friction || (is_last && part == 1.0));
        if part == 1.0 {
            let free = &search.host.unknowns.free;
            x = (0..x.len()).map(|k| if free[k] { x[k] } else { target[k] }).collect();
            return equilibrium(search, &x, &mut counts.rigid_steps).await;
        }
        if !search.may_go_on() {
            return Err(not_reached(search, counts));
        }
        x = equilibrium(search, &x, &mut counts.rigid_steps).await?.state.x;
    }
}

/// The equilibrium with slip that counts from where pairs first touched: from the last of these places, with the contact as it was `before`, else
/// from where it was found.
async fn from_first_touch<const D: usize>(
    search: &mut Search<D>,
    reached: Reached<D>,
    (target, before): (&[f64], Option<Before<D>>),
    counts: &mut Counts,
) -> Result<Reached<D>, Trouble> {
    let found = search.host.contact(|contact| Before::of(contact)).await;
    let Some(x) = first_touches(search, &reached.state).await? else { return Ok(reached) };
    let Reached { state, verdict, way } = reached;
    let state = state.again(&search.host).await?;
    let is_same = search.balance.judge(&search.host, &search.assembly, &state).await? != Verdict::Not;
    let reached = Reached { state, verdict, way };
    if is_same {
        return Ok(reached);
    }
    let told = search.warnings.len();
    if let Some(before) = before {
        let here = search.host.contact(|contact| Before::of(contact)).await;
        search.host.contact(|contact| before.with_first_touches(contact).put_back(contact)).await;
        match led(search, &x, (target, true), counts).await {
            Ok(again) => return Ok(again),
            Err(_) => search.host.contact(|contact| here.put_back(contact)).await,
        }
        search.warnings.truncate(told);
    }
    search.begin_attempt();
    search.updates.begin(true);
    match balanced(search, &reached.state.x).await {
        Ok(again) => Ok(again),
        Err(_) => {
            search.warnings.truncate(told);
            search.host.contact(|contact| found.put_back(contact)).await;
            search.warn(STRAIGHT.to_owned());
            let state = reached.state.again(&search.host).await?;
            Ok(Reached { state, ..reached })
        }
    }
}

/// With what was in the way: steps that become shorter and shorter end here, and not where they fail.
fn not_reached<const D: usize>(search: &Search<D>, counts: &Counts) -> Trouble {
    let solves = search.host.solves();
    let why = counts.trouble.as_ref().map_or_else(String::new, |trouble| format!(": {trouble}"));
    Trouble::Failed(format!("the prescribed values were not reached after {solves} linear solves{why}"))
}

/// Moves what is prescribed, and the bodies with it as their tangent says, as far as nothing passes through anything: which part.
async fn carried<const D: usize>(
    search: &mut Search<D>,
    x: &mut Vec<f64>,
    way: &[f64],
    counts: &mut Counts,
) -> Result<f64, Trouble> {
    let state = State::at(&search.host, x.clone(), true).await?;
    let mut step = None;
    if search.is_condensed() {
        let tolerances = [FINER * search.options.tolerance, 0.0];
        step = search.host.condensed(&state.x, &state.inside, way, tolerances).await.ok().map(|(step, _)| step);
    }
    let is_solved = step.is_some() && search.options.is_condensed_on_contact;
    let step = match step {
        Some(step) => step,
        None if !search.may_go_on() => return Err(not_reached(search, counts)),
        None => predicted(search, &state, way).await?,
    };
    if let Some(patches) = &mut search.patches {
        patches.begin();
    }
    let mut part = search.allowed(&state.x, &step).await?;
    if part < 1.0 && is_solved && is_in_order(search, &moved(&state.x, 1.0, &step)).await? {
        part = 1.0;
    }
    if part <= 0.0 {
        return Err(Trouble::Failed("no part of the prescribed motion is possible: bodies overlap too far".into()));
    }
    for _ in 0..HALVINGS {
        let next = moved(&state.x, part, &step);
        match State::at(&search.host, next.clone(), true).await {
            Ok(_) => {
                *x = next;
                return Ok(part);
            }
            Err(trouble @ (Trouble::Contact(_) | Trouble::Host(_))) => {
                (part, counts.trouble) = (0.5 * part, Some(trouble.to_string()));
            }
            Err(other) => return Err(other),
        }
    }
    let why = counts.trouble.as_deref().unwrap_or_default();
    Err(Trouble::Failed(format!("bodies cannot be evaluated after any part of the prescribed motion: {why}")))
}

/// Whether the end of a step for which the contact was solved is an equilibrium in which bodies hardly overlap: gaps, linearised where the step
/// began, judge it worse than it is where facets are short beside it.
async fn is_in_order<const D: usize>(search: &mut Search<D>, x: &[f64]) -> Result<bool, Trouble> {
    let end = match State::at(&search.host, x.to_vec(), false).await {
        Ok(end) => end,
        Err(Trouble::Contact(_) | Trouble::Host(_)) => return Ok(false),
        Err(other) => return Err(other),
    };
    let norm = |forces: &[f64]| search.host.unknowns.free_norm(forces);
    let forces = norm(&end.inside).max(norm(&end.forces));
    Ok(end.norm(&search.host) <= IN_ORDER * forces && end.contact.penetration <= search.assembly.finest())
}

/// The step that the tangent gives.
async fn predicted<const D: usize>(search: &Search<D>, state: &State<D>, way: &[f64]) -> Result<Vec<f64>, Trouble> {
    let host = &search.host;
    let driven = host.product(way.to_vec(), false).await?;
    let (coords, motion) = (host.unknowns.coords(&state.x), host.unknowns.spread(way));
    let push = host
        .contact(move |contact| Ok::<_, Error>(contact.tangent(&coords, TangentPart::Semidefinite)?.product(&motion)));
    let pushed = host.unknowns.gather(&push.await?);
    let right = (0..way.len()).map(|k| -(state.residual[k] + driven[k] + pushed[k])).collect();
    let shift = if search.motions.is_empty() { 0.0 } else { SHIFT };
    let system = System { x: &state.x, part: TangentPart::Semidefinite, shift };
    Ok(moved(&host.solve(system, right).await?, 1.0, way))
}

async fn finished<const D: usize>(
    search: &mut Search<D>,
    reached: Reached<D>,
    counts: &Counts,
) -> Result<Found<D>, Trouble> {
    let (solves, left) = (search.host.solves(), search.balance.relative());
    if reached.verdict == Verdict::Rounded && left > search.options.tolerance {
        let text = format!("the residual stays at {left:.1e} of the forces: the host's own forces are rounded so far");
        search.warn(text);
    }
    if let Some(text) = rounded(search, &reached.state, reached.verdict).await {
        search.warn(text);
    }
    for text in doubtful(search, &reached).await {
        search.warn(text);
    }
    if let Some(text) = held_apart(search).await {
        search.warn(text);
    }
    for text in locking(search).await.into_iter().chain(held(search, &reached.state).await?) {
        search.warn(text);
    }
    if let Some(text) = search.updates.left(search.assembly.finest()) {
        search.warn(text);
    }
    if let Some(most) = search.updates.most_without() {
        let scale = search.balance.scale();
        for text in within_facets((&search.host, &search.assembly), (&reached.state, scale), most).await {
            search.warn(text);
        }
    }
    if !breaking(&search.host, &reached.state.x).await?.is_empty() {
        // What an interface held when the step began it may hold no more.
        let coords = search.host.unknowns.coords(&reached.state.x);
        search.motions = Motions::loose(&search.host, &search.assembly, &coords).await?;
    }
    standing(search, &reached.state).await?;
    kept(search, &reached.state).await;
    let State { x, contact, residual, .. } = reached.state;
    let pairs: Vec<[Partner; 2]> = contact.pairs.iter().map(|pair| [pair.a, pair.b]).collect();
    let first_touches = search
        .host
        .contact(move |contact| pairs.iter().filter(|pair| contact.history.first_touches.of(pair).is_some()).count());
    let first_touches = first_touches.await;
    Ok(Found {
        x,
        contact,
        reactions: residual,
        way: reached.way,
        solves,
        rigid_steps: counts.rigid_steps,
        parts: counts.parts,
        loose_count: search.motions.count(),
        first_touches,
        updates: search.updates.count,
        penetration: search.updates.found,
        residuals: std::mem::take(&mut search.balance.history),
        free: std::mem::take(&mut search.free),
        warnings: std::mem::take(&mut search.warnings),
    })
}
