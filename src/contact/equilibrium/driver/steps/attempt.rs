//! The equilibrium from a place: each way from the same start.

use crate::contact::equilibrium::driver::asking::options::DriverOptions;
use crate::contact::equilibrium::driver::asking::outcome::Way;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::Unknowns;
use crate::contact::equilibrium::driver::progress::balance::Verdict;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::equilibrium::driver::ways::downhill::downhill;
use crate::contact::equilibrium::driver::ways::levels::levels;
use crate::contact::equilibrium::driver::ways::nearest::{Begin, nearest};
use crate::contact::equilibrium::driver::ways::settle::settle;
use crate::contact::equilibrium::driver::ways::softly::{Softly, softly};
use crate::contact::equilibrium::driver::ways::stuck::stuck;
use crate::contact::equilibrium::driver::ways::unloaded::apart;

/// What is said where the slip of the way would hold no body.
const COUNTED_ANEW: &str = "the bodies come to rest with slip counted from their position of rest, but not with slip \
    counted from the start of the step";

/// Where a load step begins, and what it moves.
pub(crate) struct LoadStep<const D: usize> {
    pub(crate) unknowns: Unknowns<D>,
    pub(crate) x: Vec<f64>,
    /// How unknowns that are not free move.
    pub(crate) moved: Vec<f64>,
    pub(crate) options: DriverOptions,
}

/// What a part of a load step has found.
pub(crate) struct Reached<const D: usize> {
    pub(crate) state: State<D>,
    pub(crate) verdict: Verdict,
    pub(crate) way: Way,
}

/// The equilibrium from a place, with what is prescribed where it is.
pub(crate) async fn equilibrium<const D: usize>(
    search: &mut Search<D>,
    x: &[f64],
    rigid_steps: &mut usize,
) -> Result<Reached<D>, Trouble> {
    if search.is_at_rest(x).await? {
        return balanced(search, x).await;
    }
    let stuck = match search.falling.take() {
        Some(falling) => stuck(search, x, falling).await?,
        None => None,
    };
    let (unloaded, is_wedged) = (search.unloaded.take(), stuck.as_ref().is_some_and(|stuck| stuck.is_wedged));
    // What friction keeps wedged stays so without a load.
    for is_stuck in [is_wedged, !is_wedged] {
        let found = match (&stuck, unloaded) {
            (Some(stuck), _) if is_stuck => nearest(search, &stuck.x, Begin::Stuck).await?,
            (_, Some(unloaded)) if !is_stuck => apart(search, x, unloaded).await?,
            _ => None,
        };
        if let Some((state, verdict)) = found {
            return Ok(Reached { state, verdict, way: Way::Nearest });
        }
    }
    let settled = settle(search, x).await?;
    *rigid_steps += settled.steps;
    if settled.is_anew {
        let coords = search.host.unknowns.coords(&settled.x);
        search.host.contact(move |contact| contact.begin_step(&coords)).await?;
        search.warn(COUNTED_ANEW.to_owned());
    }
    balanced(search, &settled.x).await
}

/// The same without settling: each way, from the same start but for the last.
pub(crate) async fn balanced<const D: usize>(search: &mut Search<D>, x: &[f64]) -> Result<Reached<D>, Trouble> {
    if search.is_condensed()
        && let Some((state, verdict)) = levels(search, x).await?
    {
        return Ok(Reached { state, verdict, way: Way::Condensed });
    }
    if !search.options.is_lagged
        && let Some((state, verdict)) = nearest(search, x, Begin::Full).await?
    {
        return Ok(Reached { state, verdict, way: Way::Nearest });
    }
    rubbing(search, x).await
}

/// The equilibrium down the energy, with friction that sticks softly first where that is the shorter way: several bodies that stick to one
/// another harden by small steps.
async fn rubbing<const D: usize>(search: &mut Search<D>, x: &[f64]) -> Result<Reached<D>, Trouble> {
    let is_soft = search.has_friction && !search.options.is_lagged;
    if is_soft && search.motions.count() <= of_one_body(D) {
        return match softly(search, x).await? {
            Softly { found: Some((state, verdict)), .. } => Ok(Reached { state, verdict, way: Way::Nearest }),
            Softly { x, .. } => Ok(down(downhill(search, &x).await?)),
        };
    }
    let trouble = match downhill(search, x).await {
        Ok(found) => return Ok(down(found)),
        Err(trouble @ (Trouble::Failed(_) | Trouble::Adrift(..))) if is_soft && search.may_go_on() => trouble,
        Err(trouble) => return Err(trouble),
    };
    match softly(search, x).await?.found {
        Some((state, verdict)) => Ok(Reached { state, verdict, way: Way::Nearest }),
        None => Err(trouble),
    }
}

fn down<const D: usize>((state, verdict): (State<D>, Verdict)) -> Reached<D> {
    Reached { state, verdict, way: Way::Downhill }
}

/// Rigid motions of a body.
const fn of_one_body(dim: usize) -> usize {
    dim * (dim + 1) / 2
}
