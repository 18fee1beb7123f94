//! The surface of the bodies.
//!
//! `surface`, `boundary_facet`, `surface_of_facets`, `surface_division` (facets, of cells of first or second order) · `surface_shares`,
//! `point_weights` (by node) · `facets_around` (by vertex) · `closed`, `coinciding`, `submesh` (whether it is whole) · `symmetry` · `sags`, `facet_sags`,
//! `on_face` (what smooth faces rise above straight ones)

pub(in crate::geometry) mod boundary_facet;
pub(in crate::geometry) mod closed;
pub(in crate::geometry) mod coinciding;
pub(crate) mod facet_sags;
pub(crate) mod facets_around;
mod on_face;
pub(in crate::geometry) mod point_weights;
pub(crate) mod sags;
pub(crate) mod submesh;
pub(in crate::geometry) mod surface;
pub(in crate::geometry) mod surface_division;
pub(in crate::geometry) mod surface_of_facets;
pub(in crate::geometry) mod surface_shares;
pub(crate) mod symmetry;
