//! Shapes as contact is measured with them.

use super::convex_shape::ConvexShape;
use super::implicit_shape::ImplicitShape;
use super::signed_distance::SignedDistance;
use crate::Error;
use crate::geometry::{Bodies, Surface, Vector};
use std::sync::Arc;

/// Corners of a closed surface and its facets.
pub(crate) type Faceted<const D: usize> = (Vec<[f64; D]>, Vec<[u32; D]>);

/// A closed surface that is one body, cavities and all, and where its corners are.
pub(crate) struct Faces<const D: usize> {
    pub(crate) surface: Surface<D>,
    pub(crate) points: Vec<Vector<D>>,
}

/// A shape in its own frame, its values checked.
pub(crate) enum Solid<const D: usize> {
    /// Without facets; where its faces are flat, they are there too, for estimators that would rather have them.
    Implicit { shape: ImplicitShape<D>, faces: Option<Faces<D>> },
    /// With facets alone.
    Faceted(Faces<D>),
}

impl<const D: usize> Solid<D> {
    /// A convex shape in closed form.
    pub(super) fn convex(shape: impl ConvexShape<D> + 'static) -> Result<Self, Error> {
        let faces = shape.faces().map(|(points, facets)| Faces::new(&points, &facets)).transpose()?;
        Ok(Solid::Implicit { shape: ImplicitShape::Convex(Arc::new(shape)), faces })
    }

    /// A signed distance.
    pub(super) fn function(function: Arc<dyn SignedDistance<D>>) -> Self {
        Solid::Implicit { shape: ImplicitShape::Function(function), faces: None }
    }

    /// A closed surface.
    pub(super) fn faceted(points: &[[f64; D]], facets: &[[u32; D]]) -> Result<Self, Error> {
        Faces::new(points, facets).map(Solid::Faceted)
    }

    /// The shape as lines and points see it where its facets are not taken.
    pub(crate) fn implicit(&self) -> Option<&ImplicitShape<D>> {
        match self {
            Solid::Implicit { shape, .. } => Some(shape),
            Solid::Faceted(_) => None,
        }
    }

    /// Its facets, if it has any.
    pub(crate) fn faces(&self) -> Option<&Faces<D>> {
        match self {
            Solid::Implicit { faces, .. } => faces.as_ref(),
            Solid::Faceted(faces) => Some(faces),
        }
    }
}

impl<const D: usize> Faces<D> {
    fn new(points: &[[f64; D]], facets: &[[u32; D]]) -> Result<Self, Error> {
        let surface = Surface::from_facets(points, facets, Bodies::Ids(&vec![0; facets.len()]))?;
        let points = surface.points(points);
        Ok(Self { surface, points })
    }
}

/// A measure that has to be positive.
pub(super) fn positive(name: &'static str, value: f64) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(Error::NotPositive { name, value }) }
}
