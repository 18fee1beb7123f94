//! Lines, or isotropic segments, through the region of contact, for the laws that may be sampled.
//!
//! `pair_estimator` (which pairs are measured on lines) · `layout`, `resolution` and `bundle` (where they lie) · `crossings` and
//! `obstacle_crossings` · `visits` (line by line) · `sweep` (what is inside both sides) · `trace` (to look at)

pub(crate) mod bundle;
pub(crate) mod crossings;
pub(crate) mod layout;
pub(crate) mod obstacle_crossings;
pub(crate) mod pair_estimator;
pub(crate) mod resolution;
pub(crate) mod sweep;
pub(crate) mod trace;
pub(crate) mod visits;
