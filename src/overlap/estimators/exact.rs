//! Exact clipping as an estimator.

use super::estimator::{Imbalance, OverlapEstimator, WithHessian};
use crate::Error;
use crate::overlap::normal_lines::patches::partition::Patches;
use crate::overlap::normal_lines::patches::sample::ContactSample;
use crate::overlap::normal_lines::points::contact_points::ContactPoints;
use crate::overlap::pair::fiber_trace::FiberTrace;
use crate::overlap::pair::overlap::Overlap;
use crate::overlap::pair::sides::Pair;
use crate::overlap::volume::clipped::volume::ExactPair;

/// What rounding leaves of ΣF and ΣM in exact overlaps, in parts of Σ|F| and of Σ|F| times the size of the contact.
/// Sums over some thousand nodes stay below 1e-14. Where facets are parallel within rounding, the curves in which they
/// cross are known to fewer digits.
const ROUNDING: f64 = 1e-13;

/// More than this is not rounding: a facet was taken to be on the wrong side.
const DOUBTFUL: f64 = 1e-7;

/// Contact points have the moments that turning directions would have to carry, some 1e-4 of the forces. More than this
/// comes from patches that cannot be told apart; it is not put right.
const UNBALANCED: f64 = 1e-2;

/// Overlaps by clipping.
pub(crate) struct ExactEstimator;

impl<const D: usize> OverlapEstimator<D> for ExactEstimator {
    fn overlap(&self, pair: &Pair<D>) -> Result<Option<Overlap<D>>, Error> {
        ExactPair { pair }.overlap()
    }

    fn overlap_and_hessian(&self, pair: &Pair<D>, obstacle_node: u32) -> Result<Option<WithHessian<D>>, Error> {
        ExactPair { pair }.overlap_and_hessian(obstacle_node)
    }

    fn samples(&self, pair: &Pair<D>) -> Result<Vec<ContactSample<D>>, Error> {
        ExactPair { pair }.samples()
    }

    fn contact_points(
        &self,
        pair: &Pair<D>,
        patches: &Patches<D>,
        derivative: bool,
    ) -> Result<Option<ContactPoints<D>>, Error> {
        ExactPair { pair }.contact_points(patches, derivative)
    }

    fn spacing(&self, _: &Pair<D>, _: &Patches<D>) -> Result<Option<f64>, Error> {
        Ok(None)
    }

    fn check_tangent(&self, _: &Pair<D>) -> Result<(), Error> {
        Ok(())
    }

    fn trace(&self, _: &Pair<D>) -> Result<Vec<FiberTrace<D>>, Error> {
        Ok(Vec::new())
    }

    fn imbalance_of_volume(&self, _: &Pair<D>) -> Option<Imbalance> {
        Some(Imbalance { rounding: ROUNDING, doubtful: DOUBTFUL })
    }

    fn imbalance_of_points(&self, _: &Pair<D>) -> Option<Imbalance> {
        Some(Imbalance { rounding: f64::INFINITY, doubtful: UNBALANCED })
    }

    fn prefers_facets(&self) -> bool {
        true
    }
}
