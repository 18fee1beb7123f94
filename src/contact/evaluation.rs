//! From coordinates to results.
//!
//! `state` (the bodies at the coordinates, and what is kept of them) · `walk` (which pairs may overlap, and on which threads they
//! are measured) · `submesh` (of some cells of a larger mesh: where none may be missing) · `kernels` (the evaluations, compiled for
//! 2D and for 3D) · `obstacle_rotation` (the rotations of obstacles in the tangent)

pub(super) mod kernels;
mod obstacle_rotation;
mod state;
mod submesh;
mod walk;

pub(super) use state::State;
pub(super) use submesh::Turns;
pub(crate) use submesh::{Earlier, Needed};
