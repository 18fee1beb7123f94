//! The exact estimator: facets of one side clipped by the cells of the other, and facets of both projected along a line.
//!
//! `clipping` gives the volume, `projection` the contact points of local laws.

pub(crate) mod clipping;
pub(crate) mod projection;
