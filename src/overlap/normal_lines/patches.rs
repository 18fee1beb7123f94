//! Patches of contact: which facets touch together, and along which direction.

mod clusters;
mod directions;
mod labels;
pub(crate) mod partition;
pub(crate) mod sample;
pub(crate) mod search;
