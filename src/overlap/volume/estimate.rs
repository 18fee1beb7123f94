//! The volume of a pair, by clipping or on lines.

use super::clipped::volume::ClippedPair;
use crate::Error;
use crate::overlap::lines::pair_estimator::PairEstimator;
use crate::overlap::normal_lines::points::hessian::OfLength;
use crate::overlap::pair::imbalance::Imbalance;
use crate::overlap::pair::overlap::Overlap;
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::overlap::pair::sides::Pair;
use crate::overlap::sums::block_sum::Block;
use crate::sampling::FiberPattern;

/// What rounding leaves of ΣF and ΣM in exact overlaps, in parts of Σ|F| and of Σ|F| times the size of the contact.
/// Sums over some thousand nodes stay below 1e-14. Where facets are parallel within rounding, the curves in which they
/// cross are known to fewer digits.
const ROUNDING: f64 = 1e-13;

/// More than this is not rounding: a facet was taken to be on the wrong side.
const DOUBTFUL: f64 = 1e-7;

/// Volume and its gradient, or `None` where the sides are apart.
pub(crate) fn overlap<const D: usize>(by: &PairEstimator<D>, pair: &Pair<D>) -> Result<Option<Overlap<D>>, Error> {
    match by.lines_for(pair) {
        Some(lines) => lines.of(pair).overlap(),
        None => ClippedPair { pair }.overlap(),
    }
}

/// The same with the second derivative of the volume, as blocks sorted by row and column; the translation of the pair's
/// obstacle has the number `obstacle_node`. Empty where the volume is zero; its semidefinite part is.
///
/// # Errors
/// [`Error::Unsupported`] where the volume has no second derivative, if one is asked for.
pub(crate) fn overlap_and_hessian<const D: usize>(
    by: &PairEstimator<D>,
    pair: &Pair<D>,
    second: SecondDerivative,
    obstacle_node: u32,
) -> Result<Option<(Overlap<D>, Vec<Block<D>>)>, Error> {
    let lines = by.lines_for(pair);
    let is_isotropic = lines.is_some_and(|lines| lines.options.pattern != FiberPattern::Lines);
    if is_isotropic && second != SecondDerivative::No {
        return Err(Error::Unsupported { what: "the tangent on isotropic fibers" });
    }
    match (second, lines) {
        (SecondDerivative::No | SecondDerivative::Semidefinite, _) => {
            Ok(overlap(by, pair)?.map(|overlap| (overlap, Vec::new())))
        }
        (SecondDerivative::Full, None) => ClippedPair { pair }.overlap_and_hessian(obstacle_node),
        (SecondDerivative::Full, Some(lines)) => {
            let lines = lines.of(pair);
            let Some(overlap) = lines.overlap()? else { return Ok(None) };
            let points = if overlap.has_volume() { lines.volume_points()? } else { None };
            let linear: [OfLength; 3] = [&|length| length, &|_| 1.0, &|_| 0.0];
            let hessian = points.map_or(Vec::new(), |points| points.hessian(pair, linear, false, obstacle_node));
            Ok(Some((overlap, hessian)))
        }
    }
}

/// What is expected of the balance of the forces, which is put right; `None`: it is not.
pub(crate) fn imbalance<const D: usize>(by: &PairEstimator<D>, pair: &Pair<D>) -> Option<Imbalance> {
    match by.lines_for(pair) {
        Some(lines) => lines.imbalance(),
        None => Some(Imbalance { rounding: ROUNDING, doubtful: DOUBTFUL }),
    }
}
