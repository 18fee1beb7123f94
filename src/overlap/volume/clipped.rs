//! Volume, its gradient and its second derivative by clipping facets with cells.

pub(crate) mod cell_simplices;
pub(crate) mod cell_walk;
pub(crate) mod clipper;
pub(crate) mod near_facets;
pub(crate) mod solid;
pub(crate) mod volume;
pub(crate) mod volume_hessian;
pub(crate) mod winding;
