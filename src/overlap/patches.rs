//! Patches of contact: which facets touch together, and along which direction.

pub(crate) mod directions;
pub(crate) mod labels;
pub(crate) mod partition;
pub(crate) mod search;
