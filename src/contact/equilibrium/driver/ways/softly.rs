//! The equilibrium of what rubs, by friction that sticks softly first.
//!
//! Where a body slides on two sides at once, as a plank that bends over its supports, nothing but the difference of two limits holds it, and
//! whole steps go far past the place at which one side sticks. Springs that stick softly hold it on the way there, and each equilibrium begins
//! near the next, harder one.

use super::nearest::{Begin, Enough, by_whole_steps};
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::moved;
use crate::contact::equilibrium::driver::progress::balance::Verdict;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;

/// Powers of two: the first part of their stiffness with which facets stick, and how much harder they stick the next time. Slip is divided by
/// such parts without rounding.
const SOFTEST: i32 = -10;
const HARDER: i32 = 3;

/// Residual by the forces at which facets stick harder.
const ENOUGH: f64 = 1e-2;

/// Times running that the residual may stay above its smallest: at first surfaces are not where they will press.
const ABOVE_FIRST: usize = 8;
const ABOVE: usize = 2;

/// Where softer friction has led to.
pub(crate) struct Softly<const D: usize> {
    pub(crate) found: Option<(State<D>, Verdict)>,
    /// As far as it leads.
    pub(crate) x: Vec<f64>,
}

/// The equilibrium, or a place near it.
pub(crate) async fn softly<const D: usize>(search: &mut Search<D>, start: &[f64]) -> Result<Softly<D>, Trouble> {
    let mut x = without(search, start).await?.unwrap_or_else(|| start.to_vec());
    let (mut exponent, mut above) = (SOFTEST, ABOVE_FIRST);
    loop {
        let (begin, enough) = match exponent {
            0 => (Begin::Hardened, Enough::Balanced),
            _ => (Begin::Full, Enough::Roughly(ENOUGH, above)),
        };
        stick(search, 0.5_f64.powi(-exponent)).await;
        let found = by_whole_steps(search, &x, begin, enough).await;
        stick(search, 1.0).await;
        match found? {
            found @ Some(_) if exponent == 0 => return Ok(Softly { found, x }),
            Some((state, _)) => x = state.x,
            None => return Ok(Softly { found: None, x }),
        }
        (exponent, above) = ((exponent + HARDER).min(0), ABOVE);
    }
}

/// The equilibrium without friction of bodies that are linear and held, which a host condenses; `None` where it finds none.
async fn without<const D: usize>(search: &mut Search<D>, x: &[f64]) -> Result<Option<Vec<f64>>, Trouble> {
    if !search.is_condensed() {
        return Ok(None);
    }
    let state = State::at(&search.host, x.to_vec(), true).await?;
    stick(search, 0.0).await;
    let found = search.host.condensed(x, &state.inside, &vec![0.0; x.len()], [ENOUGH, 0.0]).await;
    stick(search, 1.0).await;
    let Ok((step, _)) = found else { return Ok(None) };
    let Ok(part) = search.allowed(x, &step).await else { return Ok(None) };
    Ok(Some(moved(x, part, &step)))
}

/// Has facets stick with a part of their stiffness.
async fn stick<const D: usize>(search: &Search<D>, part: f64) {
    search.host.contact(move |contact| contact.history.sticking = part).await;
}
