//! The law `fiber`: lines along the normals of the patches where a pair touches.
//!
//! `estimate` (either way, as a pair needs) · `patches` (which facets touch together, along which direction) · `points` (contact points and sums over them) ·
//! `projected` and `sampled` (where they come from: facets projected along a direction, or lines along it)

pub(crate) mod estimate;
pub(crate) mod patches;
pub(crate) mod points;
pub(crate) mod projected;
pub(crate) mod sampled;
