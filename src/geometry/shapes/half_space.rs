//! All points whose last coordinate is at most 0.

use super::chord::{Chord, slab};
use super::convex_shape::ConvexShape;
use super::extent::Extent;
use super::revolution::last_axis;
use crate::geometry::Vector;
use std::sync::Arc;

/// A half-space; its outward normal is the last axis.
pub(crate) struct HalfSpace;

impl<const D: usize> ConvexShape<D> for HalfSpace {
    fn extent(&self) -> Extent<D> {
        Extent::HalfSpace
    }

    fn chord(&self, o: &Vector<D>, d: &Vector<D>) -> Chord<D> {
        slab(o, d, D - 1, f64::NEG_INFINITY, 0.0)
    }

    fn signed_distance(&self, x: &Vector<D>) -> (f64, Vector<D>) {
        (x[D - 1], last_axis())
    }

    fn parallel(&self, _offset: f64) -> Option<Arc<dyn ConvexShape<D>>> {
        Some(Arc::new(HalfSpace))
    }
}
