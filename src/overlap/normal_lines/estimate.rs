//! Contact points of a pair, by projection or on lines.

use super::patches::partition::Patches;
use super::patches::sample::ContactSample;
use super::points::contact_points::ContactPoints;
use super::projected::projected_pair::ProjectedPair;
use crate::Error;
use crate::overlap::lines::pair_estimator::PairEstimator;
use crate::overlap::pair::imbalance::Imbalance;
use crate::overlap::pair::sides::Pair;

/// More than rounding, from which on there is a warning. Contact points have the moments that turning directions would have to
/// carry, some 1e-4 of the forces where surfaces are curved, and a hundred times that where patches meet at a corner; nothing of
/// it is put right.
const UNBALANCED: f64 = 1e-6;

/// Where the sides touch, for the search for patches; few samples are enough.
pub(crate) fn samples<const D: usize>(by: &PairEstimator<D>, pair: &Pair<D>) -> Result<Vec<ContactSample<D>>, Error> {
    match by.lines_for(pair) {
        Some(lines) => lines.of(pair).samples(),
        None => ProjectedPair { pair }.samples(),
    }
}

/// Contact points along the directions of `patches`, or `None` where the sides are apart. `derivative` asks also for what
/// only the second derivative of a local law needs.
pub(crate) fn contact_points<const D: usize>(
    by: &PairEstimator<D>,
    pair: &Pair<D>,
    patches: &Patches<D>,
    derivative: bool,
) -> Result<Option<ContactPoints<D>>, Error> {
    match by.lines_for(pair) {
        Some(lines) => lines.of(pair).contact_points(patches),
        None => ProjectedPair { pair }.contact_points(patches, derivative),
    }
}

/// Distance between the lines along the directions of `patches`, where there are lines.
pub(crate) fn spacing<const D: usize>(
    by: &PairEstimator<D>,
    pair: &Pair<D>,
    patches: &Patches<D>,
) -> Result<Option<f64>, Error> {
    let Some(lines) = by.lines_for(pair) else { return Ok(None) };
    Ok(lines.of(pair).contact_points(patches)?.map(|points| points.spacing).filter(|spacing| *spacing > 0.0))
}

/// What is expected of the balance of the forces; `None`: it is not put right.
pub(crate) fn imbalance<const D: usize>(by: &PairEstimator<D>, pair: &Pair<D>) -> Option<Imbalance> {
    match by.lines_for(pair) {
        Some(lines) => lines.imbalance(),
        None => Some(Imbalance { rounding: f64::INFINITY, doubtful: UNBALANCED }),
    }
}
