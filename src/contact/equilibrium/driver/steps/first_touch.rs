//! Where pairs first touch that were apart when the step began.
//!
//! Friction counts the slip of a step as if all went straight from its start to its end. Bodies that a gap parts do not: they come to touch as
//! they would without contact, and what they slip from then on is another part of the way. So once an equilibrium is found in which pairs bear
//! that were apart, this looks for the place where they touched: along the way to the equilibrium that there would be without them, by the
//! tangent. Slip then counts from there.

use super::attempt::LoadStep;
use crate::Error;
use crate::contact::changes::friction_steps::touch_first;
use crate::contact::changes::poses::with_poses;
use crate::contact::equilibrium::driver::asking::host::{Host, System};
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{Unknowns, largest, moved, norm};
use crate::contact::equilibrium::driver::bodies::paths::Path;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::equilibrium::driver::ways::unloaded::solved_apart;
use crate::contact::evaluation::{Contact, kernels};
use crate::contact::partners::Poses;
use crate::contact::tangents::TangentPart;
use crate::geometry::Vector;
use crate::overlap::Partner;
use std::collections::BTreeSet;

/// Pairs that touch at different times in one step, at most; those that follow count from the last of these.
const MOST: usize = 4;

/// Part of the diagonal that holds what only these pairs hold.
const SHIFT: f64 = 1e-9;

/// Steps to the equilibrium without them, and the part of the residual that matters no more.
const STEPS: usize = 8;
const ENOUGH: f64 = 1e-6;

/// Part of the thinnest body between two looks, and how often it is looked before they become longer, by which factor.
const PACE: f64 = 0.25;
const EVEN: usize = 64;
const LONGER: f64 = 1.25;

/// Part of the thinnest body by which a place of touch is known, and by which bodies come nearer that count as touching already.
const KNOWN: f64 = 1e-9;

type Pairs = BTreeSet<[Partner; 2]>;

/// Pairs that are looked for.
#[derive(Clone)]
enum Wanted {
    Some(Pairs),
    All,
}

/// Has slip count from where pairs first touched that bear in an equilibrium and did not when the step began: the unknowns at the last of these
/// places, or `None` where there is none.
pub(crate) async fn first_touches<const D: usize>(
    search: &Search<D>,
    state: &State<D>,
) -> Result<Option<Vec<f64>>, Trouble> {
    // Bodies that nothing else holds lie on one another: many of them would touch at as many places, each for another search.
    if !search.has_friction || search.options.is_slip_straight || search.motions.are_free {
        return Ok(None);
    }
    let coords = search.host.unknowns.coords(&state.x);
    let reach = KNOWN * search.assembly.thinnest();
    let (mut new, mut last) =
        (search.host.contact(move |contact| newly_touching(contact, &coords, reach)).await?, None);
    if new.is_empty() {
        return Ok(None);
    }
    for _ in 0..MOST {
        let Some(touch) = touched(search, state, &new).await?.filter(|_| search.may_go_on()) else { break };
        new.retain(|pair| !touch.touching.contains(pair));
        last = if touch.is_at_start { last } else { Some(unknowns_at(&search.host.unknowns, &touch.coords)) };
        if new.is_empty() {
            break;
        }
    }
    Ok(last)
}

/// The same before anything has touched: the unknowns where the first of all pairs touch on the way to the equilibrium without contact, by the
/// tangent where the step begins.
pub(crate) async fn first_of_all<const D: usize>(
    search: &mut Search<D>,
    step: &LoadStep<D>,
    start: &State<D>,
) -> Result<Option<Vec<f64>>, Trouble> {
    if largest(&step.moved) == 0.0 && search.is_balanced(start).await? {
        return Ok(None);
    }
    let (coords, reach) = (search.host.unknowns.coords(&step.x), KNOWN * search.assembly.thinnest());
    if search.options.is_slip_straight
        || !search.host.contact(move |contact| is_all_apart(contact, &coords, reach)).await?
    {
        return Ok(None);
    }
    let Some(way) = free_way(search, step).await? else { return Ok(None) };
    let found = search.first_touch((&step.x, &way), (&Wanted::All, Pairs::new())).await?;
    let Some(touch) = found.filter(|touch| !touch.is_at_start) else { return Ok(None) };
    let (coords, poses, touching) = (touch.coords.clone(), touch.poses, touch.touching);
    let counts = search.host.contact(move |contact| {
        // What touches first and does not rub leads the bodies another way from there.
        let rubs = touching.iter().any(|pair| has_memory(contact, pair));
        if rubs {
            with_poses(contact, &poses, |contact| touch_first(contact, &coords, &touching, true))?;
        }
        Ok::<_, Error>(rubs)
    });
    if !counts.await? {
        return Ok(None);
    }
    Ok(Some(unknowns_at(&search.host.unknowns, &touch.coords)))
}

/// Whether the step begins here, and nothing that rubs bears, or is nearer than a reach.
fn is_all_apart<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]], reach: f64) -> Result<bool, Error> {
    let history = &contact.history;
    let begins_here = history.step.as_ref().is_some_and(|step| *step.coords.given() == coords);
    if !begins_here || !contact.has_friction() || !history.was_all_apart() {
        return Ok(false);
    }
    Ok(near_at_start(contact, reach)?.is_empty())
}

/// Pairs that are nearer than a reach where the step begins.
fn near_at_start<const D: usize>(contact: &mut Contact<D>, reach: f64) -> Result<Pairs, Error> {
    let step = contact.history.step()?;
    let (coords, poses) = (step.coords.given(), step.poses.clone());
    let found = with_poses(contact, &poses, |contact| contact.gap_constraints(&coords, reach))?;
    let is_near = |row: &usize| found.areas[*row] > 0.0 && found.gaps[*row] <= reach * found.areas[*row];
    let sorted = |row: usize| {
        let mut pair = found.partners[row];
        pair.sort_unstable();
        pair
    };
    Ok((0..found.gaps.len()).filter(is_near).map(sorted).collect())
}

/// The step from where a load step begins to the equilibrium without contact.
async fn free_way<const D: usize>(search: &Search<D>, step: &LoadStep<D>) -> Result<Option<Vec<f64>>, Trouble> {
    let host = &search.host;
    let apart = State::apart(host, step.x.clone()).await?;
    let driven = host.product(step.moved.clone(), false).await?;
    let right = apart.residual.iter().zip(&driven).map(|(force, driven)| -(force + driven)).collect();
    let system = System { x: &step.x, part: TangentPart::Semidefinite, shift: SHIFT };
    let found = solved_apart(host, system, right).await;
    match found {
        Ok(found) => Ok(Some(moved(&found, 1.0, &step.moved))),
        Err(Trouble::Contact(_) | Trouble::Host(_)) => Ok(None),
        Err(other) => Err(other),
    }
}

/// Unknowns of coordinates.
fn unknowns_at<const D: usize>(unknowns: &Unknowns<D>, coords: &[[f64; D]]) -> Vec<f64> {
    let off = |(at, base): (&[f64; D], &[f64; D])| (Vector::from(*at) - Vector::from(*base)).into();
    unknowns.gathered(&coords.iter().zip(&unknowns.base).map(off).collect::<Vec<_>>())
}

/// Pairs that bear now, and that neither bore when the step began, or were nearer than a reach, nor have a place of first touch.
fn newly_touching<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]], reach: f64) -> Result<Pairs, Error> {
    contact.history.release_friction();
    let found = kernels::slip_facets(contact, coords)?;
    let bearing = found.iter().filter(|pair| !pair.facets.is_empty()).map(|pair| pair.partners);
    let new: Pairs = bearing.filter(|pair| has_memory(contact, pair) && contact.history.was_apart(pair)).collect();
    if new.is_empty() {
        return Ok(new);
    }
    let near = near_at_start(contact, reach)?;
    Ok(new.difference(&near).copied().collect())
}

/// Whether a pair rubs, and remembers the slip of the steps before.
fn has_memory<const D: usize>(contact: &Contact<D>, pair: &[Partner; 2]) -> bool {
    let friction = contact.partners.friction_of(pair, contact.method.options());
    friction.is_active() && friction.memoryless_slip.is_none()
}

/// Finds where the first of these pairs touch, and has slip of all of them count from there.
async fn touched<const D: usize>(
    search: &Search<D>,
    state: &State<D>,
    new: &Pairs,
) -> Result<Option<Touch<D>>, Trouble> {
    let Some(step) = without(search, state, new).await? else { return Ok(None) };
    let others = state.contact.pairs.iter().map(|pair| [pair.a, pair.b]).filter(|pair| !new.contains(pair));
    let found = search.first_touch((&state.x, &step), (&Wanted::Some(new.clone()), others.collect())).await?;
    let Some(found) = found else { return Ok(None) };
    if !found.is_at_start {
        let (Touch { coords, poses, .. }, new) = (found.clone(), new.clone());
        let count = move |contact: &mut Contact<D>| {
            with_poses(contact, &poses, |contact| touch_first(contact, &coords, &new, false))
        };
        search.host.contact(count).await?;
    }
    Ok(Some(found))
}

impl<const D: usize> Search<D> {
    /// The first touch of pairs on the way to where a step leads. What nothing holds turns as a rigid body there where it deforms less by that.
    async fn first_touch(
        &self,
        (x, step): (&[f64], &[f64]),
        (wanted, others): (&Wanted, Pairs),
    ) -> Result<Option<Touch<D>>, Trouble> {
        let Some(found) = on_way(self, (x, step), (wanted.clone(), others.clone()), false).await else {
            return Ok(None);
        };
        if self.motions.is_empty() || found.is_at_start {
            return Ok(Some(found));
        }
        match on_way(self, (x, step), (wanted.clone(), others), true).await {
            Some(other) if deformed(self, &other).await? < deformed(self, &found).await? => Ok(Some(other)),
            _ => Ok(Some(found)),
        }
    }
}

/// On a way that is straight, or on which bodies turn; `others` are not looked at.
async fn on_way<const D: usize>(
    search: &Search<D>,
    (x, step): (&[f64], &[f64]),
    (wanted, others): (Wanted, Pairs),
    turns: bool,
) -> Option<Touch<D>> {
    let (to, step) = (search.host.unknowns.coords(x), search.host.unknowns.spread(step));
    let assembly = search.assembly.clone();
    let found = search.host.contact(move |contact| {
        let from = match &wanted {
            Wanted::Some(pairs) => pairs.first().and_then(|pair| contact.history.step_of(pair)),
            Wanted::All => contact.history.step.as_ref(),
        };
        let Some(from) = from else { return Ok(None) };
        let given = from.coords.given();
        let way = |row: usize| Vector::from(to[row]) + Vector::from(step[row]) - Vector::from(given[row]);
        let poses = (&from.poses, &contact.partners.obstacles.poses());
        let straight = Path::straight(&given, (0..to.len()).map(way).collect(), poses);
        let path = if turns { straight.turning(&assembly) } else { straight };
        contact.history.let_apart = others;
        let found = first_touch(contact, &path, &wanted, assembly.thinnest());
        contact.history.let_apart.clear();
        found
    });
    // Cells may be turned inside out on the way.
    found.await.unwrap_or(None)
}

/// How far the host's forces on the bodies are from those where a way begins: bodies that turn deform by that, or not, as the host has it.
async fn deformed<const D: usize>(search: &Search<D>, touch: &Touch<D>) -> Result<f64, Trouble> {
    let Host { unknowns, .. } = &search.host;
    let (start, _) = search.host.forces(&unknowns_at(unknowns, &touch.from), false).await?;
    match search.host.forces(&unknowns_at(unknowns, &touch.coords), false).await {
        Ok((forces, _)) => Ok(norm(&moved(&forces, -1.0, &start))),
        Err(Trouble::Host(_)) => Ok(f64::INFINITY),
        Err(other) => Err(other),
    }
}

/// The step from an equilibrium to that without these pairs.
async fn without<const D: usize>(
    search: &Search<D>,
    state: &State<D>,
    pairs: &Pairs,
) -> Result<Option<Vec<f64>>, Trouble> {
    let left_out = pairs.clone();
    search.host.contact(move |contact| contact.history.let_apart = left_out).await;
    let found = free_step(search, state).await;
    search.host.contact(|contact| contact.history.let_apart.clear()).await;
    match found {
        Ok(step) => Ok(Some(step)),
        Err(Trouble::Contact(_) | Trouble::Host(_)) => Ok(None),
        Err(other) => Err(other),
    }
}

/// By a step of Newton's method, which tells what nothing holds then which way it goes, and by more of them where other pairs press or bodies are
/// not linear: what of them leaves least.
async fn free_step<const D: usize>(search: &Search<D>, state: &State<D>) -> Result<Vec<f64>, Trouble> {
    let (mut x, mut first, mut best) = (state.x.clone(), 0.0, None);
    for tried in 0..=STEPS {
        let apart = match State::at(&search.host, x.clone(), true).await {
            Ok(apart) => apart,
            Err(Trouble::Contact(_) | Trouble::Host(_)) if tried > 0 => break,
            Err(other) => return Err(other),
        };
        let left = apart.norm(&search.host);
        match &best {
            None if tried == 0 => first = left,
            Some((least, _)) if left >= *least => {}
            _ => best = Some((left, x.clone())),
        }
        if left <= ENOUGH * first || tried == STEPS {
            break;
        }
        let part = if tried == 0 { TangentPart::Semidefinite } else { TangentPart::Full };
        let right = apart.residual.iter().map(|force| -force).collect();
        let step = search.host.solve(System { x: &apart.x, part, shift: SHIFT }, right).await?;
        x = moved(&x, 1.0, &step);
        // Where nothing can be evaluated after the first one it is all there is.
        best = best.or_else(|| (tried == 0).then(|| (f64::INFINITY, x.clone())));
    }
    Ok(best.map_or_else(|| vec![0.0; state.x.len()], |(_, x)| moved(&x, -1.0, &state.x)))
}

/// Where pairs touch.
#[derive(Clone)]
struct Touch<const D: usize> {
    /// Where the way began, and whether they touch there already.
    from: Vec<[f64; D]>,
    is_at_start: bool,
    coords: Vec<[f64; D]>,
    poses: Poses<D>,
    touching: Pairs,
}

/// The first of the pairs along a way; `None` where they touch nowhere.
fn first_touch<const D: usize>(
    contact: &mut Contact<D>,
    path: &Path<D>,
    wanted: &Wanted,
    thinnest: f64,
) -> Result<Option<Touch<D>>, Error> {
    let known = KNOWN * thinnest / path.longest();
    if known.is_nan() || known >= 1.0 {
        return Ok(None);
    }
    let mut pace = known * PACE / KNOWN;
    let (mut apart, mut touching) = (0.0, known);
    let mut found = touching_at(contact, path, wanted, touching)?;
    let is_at_start = !found.is_empty();
    let mut looks = 0;
    while found.is_empty() {
        if touching >= 1.0 {
            return Ok(None);
        }
        (apart, touching) = (touching, (touching + pace).min(1.0));
        looks += 1;
        pace *= if looks > EVEN { LONGER } else { 1.0 };
        found = touching_at(contact, path, wanted, touching)?;
    }
    while touching - apart > known && !is_at_start {
        let middle = 0.5 * (apart + touching);
        let there = touching_at(contact, path, wanted, middle)?;
        if there.is_empty() {
            apart = middle;
        } else {
            (touching, found) = (middle, there);
        }
    }
    let ((from, _), (coords, poses)) = (path.at(0.0), path.at(apart));
    Ok(Some(Touch { from, is_at_start, coords, poses, touching: found }))
}

/// Those of the pairs that touch at a part of the way, by surfaces that nothing moves out.
fn touching_at<const D: usize>(
    contact: &mut Contact<D>,
    path: &Path<D>,
    wanted: &Wanted,
    part: f64,
) -> Result<Pairs, Error> {
    let (coords, poses) = path.at(part);
    let found = with_poses(contact, &poses, |contact| kernels::evaluate_true(contact, &coords))?;
    let touching = found.pairs.iter().filter(|pair| pair.contact_area > 0.0).map(|pair| [pair.a, pair.b]);
    let is_wanted = |pair: &[Partner; 2]| match wanted {
        Wanted::Some(pairs) => pairs.contains(pair),
        Wanted::All => true,
    };
    Ok(touching.filter(is_wanted).collect())
}
