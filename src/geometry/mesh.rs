//! Cells as a host gives them.
//!
//! `cell`, `cell_faces`, `facet_block` (types, with their faces) · `cells`, `components`, `hanging` (neighbours, bodies, nodes on faces)
//! · `collapsed`, `weld`, `inverted` (meshes with faults)

pub(in crate::geometry) mod cell;
pub(in crate::geometry) mod cell_faces;
pub(crate) mod cells;
pub(in crate::geometry) mod collapsed;
pub(crate) mod components;
pub(in crate::geometry) mod facet_block;
pub(crate) mod hanging;
pub(crate) mod inverted;
pub(crate) mod weld;
