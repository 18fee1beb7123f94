//! The depth of a body below its own surface: a field that is linear on pieces of its cells, zero on its surface, and
//! the distance from it at the nodes. It is found once, at reference coordinates, and moves with the cells.
//!
//! `distances` (of points from a surface) · `field` (what is kept) · `cell_parts` (a cell as simplices) · `pieces` (the
//! simplices on which the field is linear).

mod cell_parts;
mod distances;
mod field;
mod pieces;

pub(crate) use field::DepthField;
pub(crate) use pieces::{DepthPiece, MOST_NODES};
