//! Bodies of cells, each with a depth.
//!
//! `cell_pieces` (the pieces of a body near by) · `facet_clip`, `facet_integrals` and `point_sums` (over the facets
//! inside the other) · `piece_moments` and `cell_integrals` (over the overlap) · `deep_bodies` (both sides together)

mod cell_integrals;
mod cell_pieces;
mod deep_bodies;
mod facet_clip;
mod facet_integrals;
mod piece_moments;
mod point_sums;

pub(super) use deep_bodies::DeepBodies;
