//! The measures of shapes, as they are read.

use super::{HeightField, Obstacle, SignedDistance};
use std::sync::Arc;

/// Where the measures of a shape are read from: a struct of the C interface, words of a command, a table of a file.
/// [`super::Shape::read`] asks for those that the kind of shape has, and for no others. Whether they are positive or finite is
/// checked when the shape is put into a contact.
pub trait Measures<const D: usize> {
    /// What is returned for a measure that is missing, or is none.
    type Error;

    /// Radius.
    fn radius(&mut self) -> Result<f64, Self::Error>;

    /// Half of the height.
    fn half_height(&mut self) -> Result<f64, Self::Error>;

    /// Halves of the sides.
    fn half_extents(&mut self) -> Result<[f64; D], Self::Error>;

    /// Points, or corners.
    fn points(&mut self) -> Result<Vec<[f64; D]>, Self::Error>;

    /// Facets, as numbers of corners from 0.
    fn facets(&mut self) -> Result<Vec<[u32; D]>, Self::Error>;

    /// Heights over a grid.
    fn height_field(&mut self) -> Result<HeightField, Self::Error>;

    /// Parts of a compound.
    fn parts(&mut self) -> Result<Vec<Obstacle<D>>, Self::Error>;

    /// The function of a body.
    fn signed_distance(&mut self) -> Result<Arc<dyn SignedDistance<D>>, Self::Error>;
}
