//! Sampling by fibers as an estimator.

use super::estimator::{Imbalance, OverlapEstimator, WithHessian};
use crate::Error;
use crate::overlap::lines::layout::FiberPair;
use crate::overlap::normal_lines::patches::partition::Patches;
use crate::overlap::normal_lines::patches::sample::ContactSample;
use crate::overlap::normal_lines::points::contact_points::ContactPoints;
use crate::overlap::normal_lines::points::hessian::OfLength;
use crate::overlap::pair::fiber_trace::FiberTrace;
use crate::overlap::pair::options::FiberOptions;
use crate::overlap::pair::overlap::Overlap;
use crate::overlap::pair::sides::Pair;
use crate::sampling::{Family, FiberPattern};

/// Overlaps by sampling.
pub(crate) struct FiberEstimator<const D: usize> {
    options: FiberOptions,
    /// The standard families; none for isotropic segments.
    families: Vec<Family<D>>,
}

impl<const D: usize> FiberEstimator<D> {
    pub(crate) fn new(options: FiberOptions) -> Self {
        let with_lines = options.pattern == FiberPattern::Lines;
        Self { options, families: if with_lines { Family::all(options.seed) } else { Vec::new() } }
    }

    fn of<'a>(&'a self, pair: &'a Pair<'a, D>) -> FiberPair<'a, D> {
        FiberPair { pair, families: &self.families, options: &self.options }
    }
}

/// Sampling leaves an imbalance, of any size where few lines meet the overlap.
const EXPECTED: Imbalance = Imbalance { rounding: 0.0, doubtful: f64::INFINITY };

impl<const D: usize> OverlapEstimator<D> for FiberEstimator<D> {
    fn overlap(&self, pair: &Pair<D>) -> Result<Option<Overlap<D>>, Error> {
        self.of(pair).overlap()
    }

    fn overlap_and_hessian(&self, pair: &Pair<D>, obstacle_node: u32) -> Result<Option<WithHessian<D>>, Error> {
        let Some(overlap) = self.overlap(pair)? else { return Ok(None) };
        let points = if overlap.has_volume() { self.of(pair).volume_points()? } else { None };
        let linear: [OfLength; 3] = [&|length| length, &|_| 1.0, &|_| 0.0];
        let hessian = points.map_or(Vec::new(), |points| points.hessian(pair, linear, false, obstacle_node));
        Ok(Some((overlap, hessian)))
    }

    fn samples(&self, pair: &Pair<D>) -> Result<Vec<ContactSample<D>>, Error> {
        self.of(pair).samples()
    }

    fn contact_points(
        &self,
        pair: &Pair<D>,
        patches: &Patches<D>,
        _derivative: bool,
    ) -> Result<Option<ContactPoints<D>>, Error> {
        self.of(pair).contact_points(patches)
    }

    fn spacing(&self, pair: &Pair<D>, patches: &Patches<D>) -> Result<Option<f64>, Error> {
        Ok(self.of(pair).contact_points(patches)?.map(|points| points.spacing).filter(|spacing| *spacing > 0.0))
    }

    fn check_tangent(&self, _: &Pair<D>) -> Result<(), Error> {
        let has_lines = !self.families.is_empty();
        if has_lines { Ok(()) } else { Err(Error::Unsupported { what: "the tangent on isotropic fibers" }) }
    }

    fn trace(&self, pair: &Pair<D>) -> Result<Vec<FiberTrace<D>>, Error> {
        self.of(pair).trace()
    }

    fn imbalance_of_volume(&self, _: &Pair<D>) -> Option<Imbalance> {
        self.options.momentum_correction.then_some(EXPECTED)
    }

    fn imbalance_of_points(&self, _: &Pair<D>) -> Option<Imbalance> {
        self.options.momentum_correction.then_some(EXPECTED)
    }

    fn prefers_facets(&self) -> bool {
        false
    }
}
