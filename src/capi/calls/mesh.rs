//! Contexts from meshes, and what they say of the mesh.

pub(super) mod basis;
pub(super) mod boundary_facets;
pub(super) mod counts;
pub(super) mod creation;
pub(super) mod facet_block;
pub(super) mod point_weights;
pub(super) mod reference;
pub(super) mod release;
pub(super) mod surfaces;
