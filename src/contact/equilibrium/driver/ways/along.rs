//! The least energy along a step.

use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{dot, moved};
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;

/// Places along a step, at most.
const TRIALS: usize = 20;

/// How many steps long, at most, and how much further the next place is while the energy falls.
const LONGEST: f64 = 1e3;
const FURTHER: f64 = 4.0;

/// Slope by that at the start at which a place is as good as the least one.
const FLAT: f64 = 0.3;

/// The state at the least energy along a step, of which it has this slope here, and the part of the step; the step that may be taken is `most`
/// of it. Where bodies creep to a place where they stick, it lies many steps ahead, or within a small part of one.
pub(crate) async fn along<const D: usize>(
    search: &Search<D>,
    state: &State<D>,
    (step, slope): (&[f64], f64),
    most: f64,
) -> Result<(State<D>, f64), Trouble> {
    let longest = match most < 1.0 {
        true => most,
        false => LONGEST * search.allowed(&state.x, &step.iter().map(|x| LONGEST * x).collect::<Vec<_>>()).await?,
    };
    let (mut low, mut high) = ((0.0, slope), None);
    let (mut part, mut best, mut why) = (most, None, String::new());
    for _ in 0..TRIALS {
        match State::at(&search.host, moved(&state.x, part, step), false).await {
            Ok(next) => {
                let ahead = dot(&search.host.unknowns.freed(next.residual.clone()), step);
                let (falls, is_flat) = (ahead < 0.0, ahead.abs() <= FLAT * slope.abs());
                if falls || is_flat || best.is_none() {
                    best = Some((next, part));
                }
                if is_flat || falls && part >= longest {
                    break;
                }
                match falls {
                    true => low = (part, ahead),
                    false => high = Some((part, Some(ahead))),
                }
            }
            Err(trouble @ (Trouble::Contact(_) | Trouble::Host(_))) => {
                (high, why) = (Some((part, None)), trouble.to_string());
            }
            Err(other) => return Err(other),
        }
        part = match high {
            None => (FURTHER * part).min(longest),
            Some((far, None)) => 0.5 * (low.0 + far),
            Some((far, Some(ahead))) => {
                let width = far - low.0;
                (low.0 + width * low.1 / (low.1 - ahead)).clamp(low.0 + 0.1 * width, far - 0.1 * width)
            }
        };
    }
    best.ok_or_else(|| Trouble::Failed(format!("bodies cannot be evaluated along any part of a step: {why}")))
}
