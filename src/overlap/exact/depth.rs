//! The law `depth` of bodies by exact clipping: facets by the pieces of the other body on which its depth is linear, and
//! the pieces of either by those of the other.
//!
//! `facet_clip` and `facet_integrals` (over the facets inside the other) · `piece_moments` (over the overlap) ·
//! `two_bodies` (both sides together)

mod facet_clip;
mod facet_integrals;
mod piece_moments;
mod two_bodies;

pub(crate) use two_bodies::depth_integral;
