//! Cells, boundary facets, crossings of lines with them, and obstacles. No randomness here.

#[cfg(test)]
mod against_parry;
pub(crate) mod boundary;
mod march;
pub(crate) mod mesh;
pub(crate) mod primitives;
pub(crate) mod second_order;
pub(crate) mod shapes;

pub use boundary::boundary_facet::BoundaryFacet;
pub(crate) use boundary::coinciding::CoincidingFaces;
pub use boundary::point_weights::PointWeights;
pub use boundary::surface::Surface;
pub(crate) use march::{Intersection, MarchFailure, ROUNDS as MARCH_ROUNDS, SearchInterval, march};
pub use mesh::cell::{Bodies, CellBlock, CellType};
pub use mesh::facet_block::{FacetBlock, FacetType};
pub(crate) use primitives::facet::{cross_matrix, moment};
pub(crate) use primitives::motion::{Motion, turn_about};
pub use primitives::pose::Pose;
pub(crate) use primitives::weighting::Weighting;
pub use second_order::Basis;
pub use shapes::{HeightField, Measures, Obstacle, Shape, ShapeKind, SignedDistance};

/// Point or vector of `D` components.
pub type Vector<const D: usize> = nalgebra::SVector<f64, D>;
