//! A ball about the origin; in 2D a disc.

use super::chord::{Chord, quadric};
use super::convex_shape::ConvexShape;
use super::extent::Extent;
use super::faces::positive;
use super::revolution::last_axis;
use crate::Error;
use crate::geometry::Vector;
use std::sync::Arc;

pub(super) struct Ball {
    radius: f64,
}

impl Ball {
    pub(super) fn new(radius: f64) -> Result<Self, Error> {
        Ok(Self { radius: positive("radius", radius)? })
    }
}

impl<const D: usize> ConvexShape<D> for Ball {
    fn extent(&self) -> Extent<D> {
        Extent::about_axis(self.radius, self.radius, self.radius)
    }

    fn chord(&self, o: &Vector<D>, d: &Vector<D>) -> Chord<D> {
        quadric(o, d, 1.0, self.radius)
    }

    fn signed_distance(&self, x: &Vector<D>) -> (f64, Vector<D>) {
        (x.norm() - self.radius, x.try_normalize(0.0).unwrap_or_else(last_axis))
    }

    fn parallel(&self, offset: f64) -> Option<Arc<dyn ConvexShape<D>>> {
        Some(Arc::new(Ball::new(self.radius + offset).ok()?))
    }
}
