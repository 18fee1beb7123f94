//! From coordinates to results.
//!
//! `parts` (the parts of a contact) · `bring`, `state` (the bodies at the coordinates, and what is remembered of them) · `walk` (which pairs may
//! overlap, and on which threads they are measured) · `needed`, `gathered` (of some cells of a larger mesh: where none may be
//! missing; `layer`: how near) · `sliding` (how a pair slides), `slip_facets` (where) · `measured` (what laws and friction answer) ·
//! `gradients` (derivatives) · `slopes` (along a direction) · `flux`, `friction_heat` (of scalar fields) · `worn_off` (what sliding wears off) · `kernels` (the evaluations, compiled for 2D and for 3D) · `passed` (obstacles moved through bodies) · `agreed` (what ranks must have
//! in common)

mod agreed;
mod bring;
mod flux;
mod friction_heat;
mod gathered;
mod gradients;
mod held;
pub(super) mod kernels;
mod layer;
mod measured;
mod needed;
mod parts;
mod passed;
mod points;
mod sliding;
mod slip_facets;
mod slopes;
mod state;
mod walk;
mod worn_off;

pub(crate) use agreed::hash_in_common;
pub(crate) use needed::{Needed, needed};
pub use parts::Contact;
pub(super) use parts::assemble;
pub(crate) use passed::{Passed, Stood, passed};
pub(crate) use points::moved_out;
