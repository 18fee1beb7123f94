//! The volume of an overlap, for the law `volume` and for what is told of overlaps: facets clipped by cells (`clipped`).

pub(crate) mod clipped;
