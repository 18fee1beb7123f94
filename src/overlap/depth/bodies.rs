//! The law `depth` of bodies by exact clipping: facets by the pieces of the other body on which its depth is linear, and
//! the pieces of either by those of the other.
//!
//! `cell_pieces` (the pieces near by) · `facet_clip`, `facet_integrals`, `facet_blocks`, `point_sums` (over the facets inside
//! the other) · `piece_moments`, `cell_integrals` (over the overlap) · `deep_bodies`, `two_bodies` (both sides together)

mod cell_integrals;
mod cell_pieces;
mod deep_bodies;
mod facet_blocks;
mod facet_clip;
mod facet_integrals;
mod piece_moments;
mod point_sums;
mod two_bodies;

pub(crate) use two_bodies::of_bodies;
