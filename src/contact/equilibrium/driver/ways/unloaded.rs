//! Bodies whose load is gone: they come to rest undeformed beside one another.
//!
//! Where contact ends, surfaces part in some order, and what parts last pulls or rubs bodies along that nothing else holds. They stay where
//! they are by this way: they are relaxed without contact, and then moved out of what they overlap.

use super::quadratic::Quadratic;
use crate::Error;
use crate::contact::equilibrium::driver::asking::host::{Host, System};
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{largest, moved};
use crate::contact::equilibrium::driver::bodies::elastic::{deformed, undeformed};
use crate::contact::equilibrium::driver::bodies::rows::Rows;
use crate::contact::equilibrium::driver::progress::balance::Verdict;
use crate::contact::equilibrium::driver::progress::search::{Search, Unloaded};
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::evaluation::Contact;
use crate::contact::tangents::TangentPart;
use nalgebra::{DMatrix, DVector};

/// Steps, at most.
const MOST: usize = 6;

/// Part of the diagonal that holds what nothing else holds: less of it lets rounding move bodies, more is seen in their deformation.
const SHIFT: f64 = 1e-9;

/// Stiffness of the way by that of the contact: bodies go as far as contact asks.
const SOFT: f64 = 1e-10;

/// Gap that is left, by the thinnest body.
const CLEAR: f64 = 1e-9;

/// How far bodies may be moved out of one another, by what the load had deformed them, for every body: it was 1.5 at most in stacks, and bodies
/// that overlap undeformed are pressed.
const FARTHER: f64 = 4.0;

/// Whether bodies are in equilibrium undeformed.
pub(crate) async fn is_gone<const D: usize>(search: &Search<D>, start: &State<D>) -> Result<Option<Unloaded>, Trouble> {
    let host = &search.host;
    let enough = search.options.tolerance * host.unknowns.free_norm(&start.forces);
    let (_, deformed) = deformed(host, &start.x).await?;
    if start.norm(host) <= enough || enough == 0.0 || deformed == 0.0 {
        return Ok(None);
    }
    let Some(undeformed) = undeformed(host, &start.x).await else { return Ok(None) };
    match host.forces(&undeformed, false).await {
        Ok((forces, _)) if host.unknowns.free_norm(&forces) <= enough => {
            Ok(Some(Unloaded { enough, farthest: FARTHER * search.assembly.rows.len() as f64 * deformed }))
        }
        Ok(_) | Err(Trouble::Host(_)) => Ok(None),
        Err(other) => Err(other),
    }
}

/// The equilibrium in which nothing presses, or `None` where there is none beside the start.
pub(crate) async fn apart<const D: usize>(
    search: &mut Search<D>,
    start: &[f64],
    unloaded: Unloaded,
) -> Result<Option<(State<D>, Verdict)>, Trouble> {
    let let_go = |contact: &mut Contact<D>| {
        let before = contact.all_multipliers();
        contact.scale_multipliers(0.0);
        before
    };
    let before = search.host.contact(let_go).await;
    match untouched(search, start, unloaded).await {
        Ok(Some(state)) => {
            search.balance.again();
            let verdict = search.balance.judge(&search.host, &search.assembly, &state).await?;
            if verdict != Verdict::Not {
                return Ok(Some((state, verdict)));
            }
        }
        Ok(None) | Err(Trouble::Host(_) | Trouble::Contact(_)) => {}
        Err(other) => return Err(other),
    }
    search.host.contact(move |contact| contact.put_back_multipliers(before)).await;
    Ok(None)
}

/// Where bodies are relaxed and apart; `None` where they stay in one another, or would have to pass through one another.
async fn untouched<const D: usize>(
    search: &Search<D>,
    start: &[f64],
    Unloaded { enough, farthest }: Unloaded,
) -> Result<Option<State<D>>, Trouble> {
    let (mut x, mut way) = (start.to_vec(), 0.0);
    for round in 0..MOST {
        let Some(state) = relaxed(search, x, enough).await? else { return Ok(None) };
        let state = state.again(&search.host).await?;
        let is_at_rest = state.norm(&search.host) <= enough;
        let step = match is_at_rest && state.contact.contact_area == 0.0 {
            true => None,
            false => way_out(search, &state.x, (round > 0).then_some(state.contact.penetration)).await?,
        };
        way += step.as_ref().map_or(0.0, |step| largest(step));
        x = match step.filter(|_| way <= farthest && round + 1 < MOST) {
            Some(step) => moved(&state.x, 1.0, &step),
            None if is_at_rest => {
                let is_free = search.allowed(start, &moved(&state.x, -1.0, start)).await? == 1.0;
                return Ok(is_free.then_some(state));
            }
            None => return Ok(None),
        };
    }
    Ok(None)
}

/// Where bodies are in equilibrium while surfaces count as apart.
async fn relaxed<const D: usize>(
    search: &Search<D>,
    mut x: Vec<f64>,
    enough: f64,
) -> Result<Option<State<D>>, Trouble> {
    let shift = if search.motions.is_empty() { 0.0 } else { SHIFT };
    for tried in 0..=MOST {
        let state = State::apart(&search.host, x).await?;
        if state.norm(&search.host) <= enough {
            return Ok(Some(state));
        }
        if tried == MOST || !search.may_go_on() {
            break;
        }
        let system = System { x: &state.x, part: TangentPart::Full, shift };
        let right = state.residual.iter().map(|force| -force).collect();
        let step = solved_apart(&search.host, system, right).await;
        x = moved(&state.x, 1.0, &step?);
    }
    Ok(None)
}

/// The solution of a system in which surfaces count as apart.
pub(crate) async fn solved_apart<const D: usize>(
    host: &Host<D>,
    system: System<'_>,
    right: Vec<f64>,
) -> Result<Vec<f64>, Trouble> {
    let coords = host.unknowns.coords(system.x);
    let let_apart = host.contact(move |contact| {
        contact.history.apart_at = Some(contact.mesh.points(&coords)?.into_owned());
        Ok::<_, Error>(())
    });
    let_apart.await?;
    let found = host.solve(system, right).await;
    host.contact(|contact| contact.history.apart_at = None).await;
    found
}

/// The shortest way of loose bodies out of what they overlap, to a gap beyond a penetration; without one, until surfaces that overlap lie on
/// one another as well as they can.
async fn way_out<const D: usize>(
    search: &Search<D>,
    x: &[f64],
    beyond: Option<f64>,
) -> Result<Option<Vec<f64>>, Trouble> {
    let Search { host, assembly, motions, .. } = search;
    if motions.is_empty() {
        return Ok(None);
    }
    let Some(rows) = Rows::near(host, x, 0.25 * assembly.thinnest()).await? else { return Ok(None) };
    let (mean, turn) = motions.ways(host, assembly);
    let changes: Vec<Vec<f64>> = motions.fields.iter().map(|field| rows.along(field)).collect();
    let (count, pressed) = (motions.count(), rows.weight.iter().sum::<f64>());
    let way = SOFT * pressed * (mean + turn + SOFT * DMatrix::identity(count, count));
    let asked: Vec<usize> = (0..rows.gap.len()).filter(|&row| beyond.is_some() || rows.gap[row] < 0.0).collect();
    let gap = beyond.map_or(0.0, |penetration| penetration + CLEAR * assembly.thinnest());
    let gaps = DVector::from_iterator(asked.len(), asked.iter().map(|&row| rows.gap[row] - gap));
    let slopes = DMatrix::from_fn(asked.len(), count, |row, col| changes[col][asked[row]]);
    let weights = DVector::from_iterator(asked.len(), asked.iter().map(|&row| rows.weight[row]));
    let quadratic = match beyond {
        Some(_) => Quadratic { load: DVector::zeros(count), stiffness: way, gaps, slopes, weights },
        None => {
            let weighted = DMatrix::from_diagonal(&weights) * &slopes;
            let (load, stiffness) = (-(weighted.transpose() * gaps), way + weighted.transpose() * slopes);
            let (gaps, slopes, weights) = (DVector::zeros(0), DMatrix::zeros(0, count), DVector::zeros(0));
            Quadratic { load, stiffness, gaps, slopes, weights }
        }
    };
    let all: Vec<usize> = (0..count).collect();
    Ok(Some(motions.combined(&quadratic.least_along(&all))))
}
