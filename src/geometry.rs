//! Cells, boundary facets, crossings of lines with them, and obstacles. No randomness here.

pub(crate) mod aabb;
#[cfg(test)]
mod against_parry;
mod boundary_facet;
mod cell;
mod cell_faces;
pub(crate) mod cells;
mod closed;
mod coinciding;
mod collapsed;
pub(crate) mod components;
pub(crate) mod convex_piece;
pub(crate) mod crossing;
pub(crate) mod facet;
mod facet_block;
pub(crate) mod facet_sags;
pub(crate) mod facet_slopes;
pub(crate) mod hanging;
pub(crate) mod inside;
pub(crate) mod inverted;
mod march;
pub(crate) mod nearest_on_facet;
pub(crate) mod orientation;
pub(crate) mod plane;
mod point_weights;
mod pose;
pub(crate) mod quadrature;
pub(crate) mod sags;
pub(crate) mod second_order;
pub(crate) mod shapes;
pub(crate) mod simplex;
pub(crate) mod simplex_rule;
pub(crate) mod submesh;
mod surface;
mod surface_division;
mod surface_of_facets;
mod surface_shares;
pub(crate) mod symmetry;
pub(crate) mod tree;
pub(crate) mod weighting;
pub(crate) mod weld;

pub use boundary_facet::BoundaryFacet;
pub use cell::{Bodies, CellBlock, CellType};
pub(crate) use coinciding::CoincidingFaces;
pub(crate) use facet::{cross_matrix, moment};
pub use facet_block::{FacetBlock, FacetType};
pub(crate) use march::{Intersection, MarchFailure, ROUNDS as MARCH_ROUNDS, SearchInterval, march};
pub use point_weights::PointWeights;
pub use pose::Pose;
pub use second_order::Basis;
pub use shapes::{HeightField, Measures, Obstacle, Shape, ShapeKind, SignedDistance};
pub use surface::Surface;
pub(crate) use weighting::Weighting;

/// Point or vector of `D` components.
pub type Vector<const D: usize> = nalgebra::SVector<f64, D>;
