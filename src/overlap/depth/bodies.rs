//! The law `depth` of bodies by exact clipping: facets by the pieces of the other body on which its depth is linear; from what is left
//! of them, how much of every piece lies in the overlap.
//!
//! `cell_pieces` (the pieces near by) · `facet_clip`, `facet_part`, `facet_integrals`, `facet_blocks`, `point_sums` (over the facets
//! inside the other) · `boundary_moments`, `inside_moments`, `piece_moments`, `cell_integrals` (over the overlap) · `deep_bodies`,
//! `two_bodies` (both sides together) · `depth_slopes` (by what the pieces have)

#[cfg(test)]
mod against_clipping;
mod boundary_moments;
mod cell_integrals;
mod cell_pieces;
mod deep_bodies;
mod depth_slopes;
mod facet_blocks;
mod facet_clip;
mod facet_integrals;
mod facet_part;
mod inside_moments;
mod piece_moments;
mod point_sums;
mod two_bodies;

pub(super) use cell_pieces::CellPieces;
pub(super) use deep_bodies::{CHUNK, DeepBodies};
pub(crate) use depth_slopes::{DepthSeeds, depth_slopes};
pub(super) use facet_clip::{Found, clip};
pub(super) use facet_integrals::FLAT;
pub(super) use facet_part::FacetPart;
pub(super) use point_sums::PointSums;
pub(super) use two_bodies::of_bodies;
