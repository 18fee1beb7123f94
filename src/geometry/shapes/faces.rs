//! The faces of a shape, where it has any, and what its measures must be.

use super::flat_faces::FlatFaces;
use crate::Error;
use crate::geometry::{Bodies, Surface, Vector};
use std::sync::OnceLock;

/// Corners of a closed surface and its facets.
pub(crate) type Faceted<const D: usize> = (Vec<[f64; D]>, Vec<[u32; D]>);

/// A closed surface that is one body, cavities and all, and where its corners are.
pub(crate) struct Faces<const D: usize> {
    pub(crate) surface: Surface<D>,
    pub(crate) points: Vec<Vector<D>>,
    flat: OnceLock<FlatFaces>,
}

impl<const D: usize> Faces<D> {
    pub(super) fn new(points: &[[f64; D]], facets: &[[u32; D]]) -> Result<Self, Error> {
        let surface = Surface::from_facets(points, facets, Bodies::Ids(&vec![0; facets.len()]))?;
        let points = surface.points(points);
        Ok(Self { surface, points, flat: OnceLock::new() })
    }

    /// Its flat faces; looked for when first asked for.
    pub(crate) fn flat(&self) -> &FlatFaces {
        self.flat.get_or_init(|| FlatFaces::new(&self.surface.facets, &self.points))
    }
}

/// A measure that has to be positive.
pub(super) fn positive(name: &'static str, value: f64) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(Error::NotPositive { name, value }) }
}
