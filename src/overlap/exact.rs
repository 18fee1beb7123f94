//! The exact estimator: facets of one side clipped by the cells of the other, and facets of both projected along a
//! line.
//!
//! `clipping` gives the volume, `projection` the contact points of local laws. Exact for straight-sided cells and
//! flat-sided obstacles.

pub(crate) mod clipping;
pub(crate) mod depth;
pub(crate) mod estimator;
pub(crate) mod projection;

pub(crate) use estimator::ExactEstimator;
