//! The partners of a pair.

use std::fmt;

/// One side of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Partner {
    /// Body of the mesh, by index (0, 1, … in the order of their ids).
    Body(usize),
    /// Obstacle, by index.
    Obstacle(usize),
}

impl fmt::Display for Partner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Partner::Body(index) => write!(f, "body {index}"),
            Partner::Obstacle(index) => write!(f, "obstacle {index}"),
        }
    }
}
