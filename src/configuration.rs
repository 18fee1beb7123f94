//! The bodies of a mesh at given coordinates: where their facets are, to be found by place, and what was checked.
//!
//! Topology of the search trees outlives an evaluation, boxes are refitted. No result depends on what was kept:
//! whatever a tree finds is put into ascending order before it is used.

mod bodies;
mod body_tree;
mod cell_check;
mod facet_side;
mod facet_tree;
mod passages;
mod self_contact;
mod upright;

pub(crate) use bodies::Configuration;
pub(crate) use body_tree::BodyTree;
pub(crate) use cell_check::CellCheck;
pub(crate) use facet_side::FacetSide;
pub(crate) use facet_tree::FacetTree;
