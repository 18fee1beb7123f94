//! Shapes as contact is measured with them.

use super::convex_shape::ConvexShape;
use super::faces::Faces;
use super::implicit_shape::ImplicitShape;
use super::signed_distance::SignedDistance;
use crate::Error;
use std::sync::Arc;

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
