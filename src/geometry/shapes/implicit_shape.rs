//! Shapes without facets.

use super::convex_shape::ConvexShape;
use super::extent::Extent;
use super::signed_distance::SignedDistance;
use crate::geometry::Vector;
use std::sync::Arc;

/// A shape without facets: lines meet it in closed form, or by marching along its distance.
#[derive(Clone)]
pub(crate) enum ImplicitShape<const D: usize> {
    Convex(Arc<dyn ConvexShape<D>>),
    Function(Arc<dyn SignedDistance<D>>),
}

impl<const D: usize> ImplicitShape<D> {
    /// How far it reaches; `None` where that is not known.
    pub(crate) fn extent(&self) -> Option<Extent<D>> {
        match self {
            ImplicitShape::Convex(shape) => Some(shape.extent()),
            ImplicitShape::Function(_) => None,
        }
    }

    pub(crate) fn is_half_space(&self) -> bool {
        matches!(self.extent(), Some(Extent::HalfSpace))
    }

    /// Whether it is marched, along a function that may belong to the host.
    pub(crate) fn is_function(&self) -> bool {
        matches!(self, ImplicitShape::Function(_))
    }
}

impl<const D: usize> SignedDistance<D> for ImplicitShape<D> {
    fn evaluate(&self, x: &[[f64; D]], phi: &mut [f64], gradient: &mut [[f64; D]]) -> Result<(), usize> {
        match self {
            ImplicitShape::Function(function) => function.evaluate(x, phi, gradient),
            ImplicitShape::Convex(shape) => {
                for ((x, phi), gradient) in x.iter().zip(phi).zip(gradient) {
                    let (distance, slope) = shape.signed_distance(&Vector::from(*x));
                    (*phi, *gradient) = (distance, slope.into());
                }
                Ok(())
            }
        }
    }
}
