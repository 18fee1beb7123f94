//! Surfaces that belong together: where they face one another, and what holds them there.
//!
//! `common_pieces` (of facets that face one another) · `facing_points` (quadrature on these) · `place` (a place of a facet, by the points that move it) · `frame` (how the normal of a
//! facet turns) · `hold` (by which side) · `tie` (the rows of a tie) · `tie_energy` (its energy, forces and tangent)

mod common_pieces;
mod facing_points;
mod frame;
mod hold;
mod place;
mod tie;
mod tie_energy;

pub(crate) use facing_points::{FacingSurfaces, normal_of, shape_at};
pub(crate) use tie::{LeftOut, Tie};
pub(crate) use tie_energy::{Curvature, TieAt};
