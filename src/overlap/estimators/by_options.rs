//! From the options to the estimator.

use super::auto::AutoEstimator;
use super::estimator::OverlapEstimator;
use super::exact::ExactEstimator;
use super::fibers::FiberEstimator;
use crate::overlap::pair::options::Estimator;

/// The estimator that the options name.
pub(crate) fn estimator<const D: usize>(options: &Estimator) -> Box<dyn OverlapEstimator<D>> {
    match options {
        Estimator::Fibers(options) => Box::new(FiberEstimator::new(*options)),
        Estimator::Auto(options) => Box::new(AutoEstimator::new(*options)),
        Estimator::Exact => Box::new(ExactEstimator),
    }
}
