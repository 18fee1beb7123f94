//! How far a step may go so that no body passes through another.

use crate::Error;
use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::evaluation::Contact;
use crate::geometry::Vector;

/// Part of a facet by which surfaces may come to overlap in one step beyond what they do.
const ROOM: f64 = 0.5;

/// How far a step may go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepLimit {
    /// Part of the step, at most 1, that no body passes another by.
    pub part: f64,
    /// Part of it at which the first gap closes, as far as gaps change with the slopes of now; infinite where none does within
    /// `part`.
    pub first_touch: f64,
}

/// How far a step may go, by what is known of the contact alone.
pub(in crate::contact::equilibrium) fn step_limit<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    step: &[[f64; D]],
) -> Result<StepLimit, Error> {
    check_lengths(contact, [("coords", coords.len()), ("step", step.len())])?;
    limit(contact, &Assembly::new(contact, coords)?, coords, step)
}

/// Refuses arrays with another number of rows than the contact has coordinates.
pub(crate) fn check_lengths<const D: usize>(
    contact: &Contact<D>,
    arrays: [(&'static str, usize); 2],
) -> Result<(), Error> {
    let expected = contact.surface().unknown_count();
    match arrays.into_iter().find(|(_, found)| *found != expected) {
        Some((array, found)) => Err(Error::Length { array, expected, found }),
        None => Ok(()),
    }
}

/// The same with what is known of the bodies.
pub(crate) fn limit<const D: usize>(
    contact: &Contact<D>,
    assembly: &Assembly<D>,
    coords: &[[f64; D]],
    step: &[[f64; D]],
) -> Result<StepLimit, Error> {
    let mut found = StepLimit { part: 1.0, first_touch: f64::INFINITY };
    let all = step.iter().zip(&assembly.body).filter(|(_, body)| body.is_some()).map(|(d, _)| Vector::<D>::from(*d));
    // A motion of all bodies as one does not count against one another, but against obstacles, which stay.
    let has_obstacles = contact.obstacle_count() > 0;
    let count = if has_obstacles { f64::INFINITY } else { assembly.body.iter().flatten().count().max(1) as f64 };
    let mean = all.clone().fold(Vector::<D>::zeros(), |sum, d| sum + d) / count;
    let most = all.map(|d| (d - mean).norm()).fold(0.0, f64::max);
    if most == 0.0 {
        return Ok(found);
    }
    // Without a look at what is in reach of the whole step: gaps over many sizes of the bodies are looked for among all pairs of facets.
    let part = (0.5 * assembly.thinnest() / most).min(1.0);
    found.part = part;
    let gaps = contact.gap_constraints(coords, (2.0 * part * most).max(1e-12 * assembly.size))?;
    for row in (0..gaps.gaps.len()).filter(|&row| gaps.areas[row] > 0.0) {
        let area = gaps.areas[row];
        let range = gaps.row_starts[row]..gaps.row_starts[row + 1];
        let slopes = gaps.columns[range.clone()].iter().zip(&gaps.slopes[range]);
        let change: f64 =
            slopes.map(|(&node, slope)| (0..D).map(|i| slope[i] * step[node as usize][i]).sum::<f64>()).sum();
        let (gap, closing) = (gaps.gaps[row] / area, -change / area);
        let room = gap.max(0.0) + ROOM * area.powf(1.0 / (D as f64 - 1.0));
        if closing * part > room {
            found.part = found.part.min(room / closing);
        }
        if gap > 0.0 && closing > gap {
            found.first_touch = found.first_touch.min(gap / closing);
        }
    }
    Ok(found)
}

/// Whether a step is so short beside facets and thicknesses that nothing has to be looked at.
pub(crate) fn is_short<const D: usize>(assembly: &Assembly<D>, step: &[[f64; D]]) -> bool {
    let most = step.iter().map(|d| Vector::<D>::from(*d).norm()).fold(0.0, f64::max);
    2.0 * most <= 0.25 * ROOM * assembly.finest() && 2.0 * most <= 0.5 * assembly.thinnest()
}
