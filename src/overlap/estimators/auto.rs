//! Exact where that is possible, lines elsewhere.

use super::estimator::{Imbalance, OverlapEstimator, WithHessian};
use super::exact::ExactEstimator;
use super::fibers::FiberEstimator;
use crate::Error;
use crate::geometry::Shape;
use crate::overlap::normal_lines::patches::partition::Patches;
use crate::overlap::normal_lines::patches::sample::ContactSample;
use crate::overlap::normal_lines::points::contact_points::ContactPoints;
use crate::overlap::pair::fiber_trace::FiberTrace;
use crate::overlap::pair::options::FiberOptions;
use crate::overlap::pair::overlap::Overlap;
use crate::overlap::pair::sides::{Counterpart, Pair};

/// Chooses for every pair by itself.
pub(crate) struct AutoEstimator<const D: usize> {
    fibers: FiberEstimator<D>,
}

impl<const D: usize> AutoEstimator<D> {
    /// With these options where lines are needed.
    pub(crate) fn new(fibers: FiberOptions) -> Self {
        Self { fibers: FiberEstimator::new(fibers) }
    }

    /// Everything that is bounded by facets or by a plane is exact; what is curved needs lines.
    fn of(&self, pair: &Pair<D>) -> &dyn OverlapEstimator<D> {
        match &pair.counterpart {
            Counterpart::Implicit(side) if !matches!(side.shape, Shape::HalfSpace) => &self.fibers,
            _ => &ExactEstimator,
        }
    }
}

impl<const D: usize> OverlapEstimator<D> for AutoEstimator<D> {
    fn overlap(&self, pair: &Pair<D>) -> Result<Option<Overlap<D>>, Error> {
        self.of(pair).overlap(pair)
    }

    fn overlap_and_hessian(&self, pair: &Pair<D>, obstacle_node: u32) -> Result<Option<WithHessian<D>>, Error> {
        self.of(pair).overlap_and_hessian(pair, obstacle_node)
    }

    fn samples(&self, pair: &Pair<D>) -> Result<Vec<ContactSample<D>>, Error> {
        self.of(pair).samples(pair)
    }

    fn contact_points(
        &self,
        pair: &Pair<D>,
        patches: &Patches<D>,
        derivative: bool,
    ) -> Result<Option<ContactPoints<D>>, Error> {
        self.of(pair).contact_points(pair, patches, derivative)
    }

    fn spacing(&self, pair: &Pair<D>, patches: &Patches<D>) -> Result<Option<f64>, Error> {
        self.of(pair).spacing(pair, patches)
    }

    fn check_tangent(&self, pair: &Pair<D>) -> Result<(), Error> {
        self.of(pair).check_tangent(pair)
    }

    fn trace(&self, pair: &Pair<D>) -> Result<Vec<FiberTrace<D>>, Error> {
        self.of(pair).trace(pair)
    }

    fn imbalance_of_volume(&self, pair: &Pair<D>) -> Option<Imbalance> {
        self.of(pair).imbalance_of_volume(pair)
    }

    fn imbalance_of_points(&self, pair: &Pair<D>) -> Option<Imbalance> {
        self.of(pair).imbalance_of_points(pair)
    }

    fn prefers_facets(&self) -> bool {
        true
    }
}
