//! The sampled estimator: lines, or isotropic segments, through the region of contact.

pub(crate) mod bundle;
pub(crate) mod contact_points;
pub(crate) mod crossings;
pub(crate) mod estimator;
pub(crate) mod layout;
pub(crate) mod obstacle_crossings;
pub(crate) mod resolution;
pub(crate) mod samples;
pub(crate) mod sweep;
pub(crate) mod trace;
pub(crate) mod volume;
pub(crate) mod volume_hessian;

pub(crate) use estimator::FiberEstimator;
