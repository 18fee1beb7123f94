//! The depth of a body below its own surface: a field that is linear on pieces of its cells, zero on its surface, and
//! the distance from it at the nodes. It is found once, at reference coordinates, and moves with the cells.
//!
//! `distances` (of points from a surface) · `node_depths` · `cell_parts` (a cell as simplices) · `divide` (simplices
//! about points) · `incentre` · `near_surface` and `cell_division` (cells that have nodes on the surface) · `divisions`
//! and `field` (what is kept) · `curves` and
//! `heights_in_cells` (curved faces), `rims` (where they end) · `pieces` (the simplices on which the field is linear, where they are) · `tied_layer` (what does not count) · `point_origin`,
//! `incentre_slopes` and `reference_slopes` (how the field changes as the reference moves).

mod cell_division;
mod cell_parts;
mod crest;
mod curves;
mod distances;
mod divide;
mod divisions;
mod field;
mod heights_in_cells;
mod incentre;
mod incentre_slopes;
mod near_surface;
mod node_depths;
mod pieces;
mod point_origin;
mod reference_slopes;
mod rims;
mod tied_layer;

pub(crate) use curves::{Curves, Quadratic};
pub(crate) use divisions::MOST_NODES;
pub(crate) use field::DepthField;
pub(crate) use pieces::DepthPiece;
pub(crate) use reference_slopes::{CellSlopes, ReferenceSlopes};
pub(crate) use tied_layer::TiedLayer;
