//! Analytical rigid surfaces: a profile of lines, arcs and parabolas, in the plane or swept through space, as faces of second order.
//!
//! `piece` (of a profile) · `fillet` (round corners) · `path` (its nodes) · `sweep` (along a line, or around an axis)

mod fillet;
mod path;
mod piece;
mod sweep;

pub(crate) use path::path;
pub(crate) use piece::{Piece, Profile, Wrong};
pub(crate) use sweep::{Frame, Sweep, Swept, swept};
