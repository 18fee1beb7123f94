//! The volume of an overlap, for the law `volume` and for what is told of overlaps.
//!
//! `estimate` (either way, as a pair needs) · `clipped` (facets clipped by cells) · `on_lines` (sampled)

pub(crate) mod clipped;
pub(crate) mod estimate;
mod on_lines;
