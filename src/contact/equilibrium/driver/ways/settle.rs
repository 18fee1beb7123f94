//! Rigid motions of loose bodies until contact balances their loads.

use super::quadratic::Quadratic;
use crate::Error;
use crate::contact::changes::friction_steps::take_up;
use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{dot, largest, moved};
use crate::contact::equilibrium::driver::bodies::motions::Motions;
use crate::contact::equilibrium::driver::bodies::rows::{Rows, along};
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::history::sorted;
use crate::contact::tangents::TangentPart;
use crate::overlap::Partner;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeSet;

/// Steps, at most, and for every body: those of a stack fall on one another in turn.
const MOST: usize = 150;
const BY_BODY: usize = 50;

/// Resultants that are left, by the magnitudes of the forces. Smaller ones make bodies creep along directions that nothing holds.
const LEFT: f64 = 1e-2;

/// Resultants of bodies that are on their way still.
const ON_ITS_WAY: f64 = 0.5;

/// How much dearer the way becomes where a step goes back on the one before: bodies rock to and fro on what they stand on.
const STRICTER: f64 = 4.0;

/// Part of the usual length beyond which a body is on its way, and does not nearly rest.
const FAR: f64 = 1e-2;

/// How much dearer than moving a body its turning is, while it is on its way.
const TURN: f64 = 100.0;

/// Sizes of the assembly that a body may go before nothing stops it.
const FARTHEST: f64 = 10.0;

/// What keeps motions apart that move no body by much, beside their way: so little that it does not mix what is symmetric. A body that
/// comes out of another turns by what is mixed into its way, the more the farther it goes.
const APART: f64 = 1e-12;

/// Part of the magnitudes of the forces, whichever way they look, below which a resultant is rounding: nothing drives a body along, and it
/// stays where it is. The stiffness of what it slides past or comes out of would take it along by what its mesh lacks of symmetry.
const UNDRIVEN: f64 = 1e-9;

/// Part of the load along a step that may be left, or turn, where friction is counted.
const TURNED: f64 = 0.5;

/// How often such a step is made shorter, at most.
const SHORTER: usize = 16;

/// Part of the stiffness of a pair with which bodies that are about to touch stick.
const STICK: f64 = 0.1;

/// What settling has led to.
pub(crate) struct Settled {
    pub(crate) x: Vec<f64>,
    pub(crate) steps: usize,
    /// Whether they came to rest by friction that is counted from a place on the way, not from where the step began.
    pub(crate) is_anew: bool,
}

/// From x, whose matrix the host has. The step that has begun stays as it is.
pub(crate) async fn settle<const D: usize>(search: &Search<D>, start: &[f64]) -> Result<Settled, Trouble> {
    let Search { host, motions, has_friction, .. } = search;
    if motions.is_empty() {
        return Ok(Settled { x: start.to_vec(), steps: 0, is_anew: false });
    }
    let rounding = rounding_along(search, start).await?;
    let ways = [OnTheWay::Slips, OnTheWay::None, OnTheWay::Sticks];
    let mut first = None;
    for friction in ways.into_iter().take(if *has_friction { ways.len() } else { 1 }) {
        let begun = host.contact(|contact| contact.history.begun()).await;
        let tried = attempt(search, (start, &rounding), friction).await;
        host.contact(|contact| take_up(contact, begun)).await;
        match tried {
            Ok(settled) => return Ok(settled),
            Err(trouble) => first = first.or(Some(trouble)),
        }
    }
    match first {
        Some(trouble) if motions.are_free => Err(trouble),
        // What springs hold needs no rest of its own: the equilibrium is sought from the start.
        _ => Ok(Settled { x: start.to_vec(), steps: 0, is_anew: false }),
    }
}

/// Friction of bodies on their way.
#[derive(Clone, Copy, PartialEq)]
enum OnTheWay {
    /// By the slip since the step began.
    Slips,
    /// None, nor of those that nearly rest.
    None,
    /// None, but those that nearly rest stick.
    Sticks,
}

async fn attempt<const D: usize>(
    search: &Search<D>,
    (start, rounding): (&[f64], &DVector<f64>),
    friction: OnTheWay,
) -> Result<Settled, Trouble> {
    let Search { host, assembly, motions, has_friction, .. } = search;
    let has_friction = *has_friction;
    let mut x = start.to_vec();
    let mut is_anew = false;
    let (mean, turn) = motions.ways(host, assembly);
    let usual = 0.25 * assembly.thinnest();
    let (mut length, mut trail, mut worst, mut caution) = (usual, vec![x.clone()], f64::INFINITY, 1.0);
    let mut last = vec![0.0; x.len()];
    // Bodies that fall on one another go far to and fro: slip that is counted all the way seldom lets them rest.
    let is_counted = has_friction && friction == OnTheWay::Slips;
    let by_bodies = if is_counted { 0 } else { BY_BODY * assembly.rows.len() };
    for steps in 0..MOST.max(by_bodies) {
        let mut state = State::at(host, x.clone(), false).await?;
        let (mut load, mut parts) = resultants(search, rounding, &state);
        worst = parts.iter().copied().fold(0.0, f64::max);
        if worst <= LEFT {
            return Ok(Settled { x, steps, is_anew });
        }
        let is_moving = largest(&last) > if friction == OnTheWay::Sticks { FAR * usual } else { 0.0 };
        if has_friction && friction != OnTheWay::Slips && worst > ON_ITS_WAY && is_moving {
            // A body on its way has no friction yet.
            let coords = host.unknowns.coords(&x);
            host.contact(move |contact| contact.begin_step(&coords)).await?;
            is_anew = true;
            state = state.again(host).await?;
            (load, parts) = resultants(search, rounding, &state);
        }
        if largest(&moved(&x, -1.0, start)) > FARTHEST * assembly.size {
            let text = format!("nothing stops it within {FARTHEST} sizes of the assembly");
            return Err(lost(host, assembly, &trail, &text));
        }
        let near = Rows::near(host, &x, 2.0 * length).await?;
        let dear = if worst > ON_ITS_WAY { TURN } else { 1.0 };
        let way = &mean + dear * &turn + APART * DMatrix::identity(motions.count(), motions.count());
        let stiffness =
            &motions.stiffness + tangent_on(host, motions, &x).await? + (0.5 * caution * load.amax() / length) * way;
        let about_to_stick = has_friction.then(|| (1e-3 * length, pressed(&state)));
        let quadratic = energy(motions, near.as_ref(), (load, stiffness), about_to_stick, 1e-12 * assembly.size);
        let driven: Vec<usize> = (0..motions.count()).filter(|&k| parts[k] > 0.0).collect();
        let along = quadratic.least_along(&driven);
        let step = motions.combined(&along);
        let most = largest(&step);
        if most == 0.0 || !most.is_finite() {
            break;
        }
        // As long as nothing that moves has anything in sight, twice as far the next time.
        let part = (length / most).min(1.0);
        let is_seen = near.is_some_and(|rows| rows.along(&step).iter().any(|change| part * change.abs() > 1e-6 * most));
        length = if is_seen { usual } else { 2.0 * length };
        let part = match is_counted {
            true => before_it_turns(search, &x, (&step, part), (&along, quadratic.load.dot(&along))).await?,
            false => part,
        };
        x = moved(&x, part, &step);
        trail.push(x.clone());
        caution = if dot(&step, &last) < 0.0 { STRICTER * caution } else { f64::max(1.0, 0.5 * caution) };
        last = step;
    }
    let (late, steps) = (moved(&x, -1.0, &trail[trail.len() / 2]), trail.len() - 1);
    if worst <= 0.1 && largest(&late) < usual {
        return Ok(Settled { x, steps, is_anew });
    }
    let text = format!(
        "no rigid motion balances its load after {steps} steps: it is driven on for ever, or held by friction alone"
    );
    Err(lost(host, assembly, &trail, &text))
}

/// The part of a step, at most as given, at which the load along it has not turned by much. Friction holds within a slip far shorter than a
/// step, and turns the load where the step goes on: without this bodies slide to and fro past the place at which they rest.
async fn before_it_turns<const D: usize>(
    search: &Search<D>,
    x: &[f64],
    (step, most): (&[f64], f64),
    (along, driving): (&DVector<f64>, f64),
) -> Result<f64, Trouble> {
    let (mut short, mut long) = ((0.0, driving), None);
    let mut part = most;
    for _ in 0..SHORTER {
        let state = State::at(&search.host, moved(x, part, step), false).await?;
        let load = -search.motions.along(&state.residual).dot(along);
        if load.abs() <= TURNED * driving || (load > 0.0 && part == most) {
            return Ok(part);
        }
        if load > 0.0 {
            short = (part, load);
        } else {
            long = Some((part, load));
        }
        let Some(long) = long else { break };
        let secant = short.0 + (long.0 - short.0) * short.1 / (short.1 - long.1);
        let margin = 0.1 * (long.0 - short.0);
        part = secant.clamp(short.0 + margin, long.0 - margin);
    }
    Ok(part)
}

/// What rounding of the host's own forces may leave of resultants: bodies that have come to rest have no other load.
async fn rounding_along<const D: usize>(search: &Search<D>, start: &[f64]) -> Result<DVector<f64>, Trouble> {
    let state = State::at(&search.host, start.to_vec(), false).await?;
    let rounding = search.balance.rounding(&search.host, &search.assembly, &state).await?;
    Ok(search.motions.magnitudes(&rounding.of_state))
}

/// Resultants of the residual on every motion, and their parts of the magnitudes of the forces that way; 0 of what is rounding.
fn resultants<const D: usize>(
    Search { host, motions, .. }: &Search<D>,
    rounding: &DVector<f64>,
    state: &State<D>,
) -> (DVector<f64>, DVector<f64>) {
    let load = -motions.along(&state.residual);
    let all = motions.magnitudes(&state.inside) + motions.magnitudes(&state.forces);
    let whole = |v: &[f64]| motions.whole_magnitudes(&host.unknowns, v);
    let rounded = (UNDRIVEN * (whole(&state.inside) + whole(&state.forces))).sup(rounding);
    let part = |load: f64, all: f64, rounded: f64| if load.abs() > rounded { load.abs() / all } else { 0.0 };
    let parts = load.zip_zip_map(&all, &rounded, part);
    (load, parts)
}

/// Pairs that press somewhere: what they do not touch yet slides where the rest does, and would hold it if it stuck.
fn pressed<const D: usize>(state: &State<D>) -> BTreeSet<[Partner; 2]> {
    let pairs = state.contact.pairs.iter().filter(|pair| pair.contact_area > 0.0);
    pairs.map(|pair| sorted([pair.a, pair.b])).collect()
}

/// Energy of the next step: what touches is in the load and the stiffness, what is near in the gaps. Bodies closer than a length stick, but
/// for pairs that press already.
fn energy(
    motions: &Motions,
    near: Option<&Rows>,
    (load, mut stiffness): (DVector<f64>, DMatrix<f64>),
    about_to_stick: Option<(f64, BTreeSet<[Partner; 2]>)>,
    touching: f64,
) -> Quadratic {
    let count = motions.count();
    let Some(rows) = near else {
        let (none, slopes) = (DVector::zeros(0), DMatrix::zeros(0, count));
        return Quadratic { load, stiffness, gaps: none.clone(), slopes, weights: none };
    };
    let apart: Vec<usize> = (0..rows.gap.len()).filter(|&row| rows.gap[row] > -touching).collect();
    let changes: Vec<Vec<f64>> = motions.fields.iter().map(|field| rows.along(field)).collect();
    if let Some((close, pressed)) = about_to_stick {
        for (row, slopes) in &rows.tangential {
            let is_close = rows.gap[*row].max(0.0) <= close && apart.binary_search(row).is_ok();
            if is_close && !pressed.contains(&rows.partners[*row]) {
                let jump = DVector::from_iterator(count, motions.fields.iter().map(|field| along(slopes, field)));
                stiffness += STICK * rows.weight[*row] * &jump * jump.transpose();
            }
        }
    }
    Quadratic {
        load,
        stiffness,
        gaps: DVector::from_iterator(apart.len(), apart.iter().map(|&row| rows.gap[row].max(0.0))),
        slopes: DMatrix::from_fn(apart.len(), count, |row, col| changes[col][apart[row]]),
        weights: DVector::from_iterator(apart.len(), apart.iter().map(|&row| rows.weight[row])),
    }
}

/// Φᵀ T Φ, semidefinite.
async fn tangent_on<const D: usize>(host: &Host<D>, motions: &Motions, x: &[f64]) -> Result<DMatrix<f64>, Trouble> {
    let coords = host.unknowns.coords(x);
    let fields: Vec<_> = motions.fields.iter().map(|field| host.unknowns.spread(field)).collect();
    let found = host.contact(move |contact| {
        let tangent = contact.tangent(&coords, TangentPart::Semidefinite)?;
        let products: Vec<_> = fields.iter().map(|field| tangent.product(field)).collect();
        let dot = |row: usize, col: usize| -> f64 {
            fields[row].as_flattened().iter().zip(products[col].as_flattened()).map(|(a, b)| a * b).sum()
        };
        Ok::<_, Error>(DMatrix::from_fn(fields.len(), fields.len(), dot))
    });
    let full = found.await?;
    Ok(0.5 * (&full + full.transpose()))
}

/// A refusal that names the body that moved most in the last half of the steps.
fn lost<const D: usize>(host: &Host<D>, assembly: &Assembly<D>, trail: &[Vec<f64>], what: &str) -> Trouble {
    let (last, middle) = (&trail[trail.len() - 1], &trail[trail.len() / 2]);
    match assembly.mover(&host.unknowns.spread(&moved(last, -1.0, middle))) {
        Some(mover) => Trouble::unheld(&mover, what),
        None => Trouble::Failed(what.to_owned()),
    }
}
