//! Cells, boundary facets, crossings of lines with them, and obstacles. No randomness here.

mod cell;
mod facet;
mod obstacle;
mod pose;
mod surface;

pub use cell::{Bodies, CellBlock, CellType};
pub use obstacle::{Obstacle, Shape, SignedDistance};
pub use pose::Pose;
pub use surface::Surface;

/// Point or vector of `D` components.
pub type Vector<const D: usize> = nalgebra::SVector<f64, D>;
