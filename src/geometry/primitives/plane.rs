//! The boundary of a half-space.

use super::aabb::Aabb;
use crate::geometry::{Pose, Vector};

/// The surface of a half-space.
pub(crate) struct Plane<const D: usize> {
    pub(crate) point: Vector<D>,
    pub(crate) normal: Vector<D>,
}

impl<const D: usize> Plane<D> {
    pub(crate) fn of(pose: &Pose<D>) -> Self {
        let mut up = Vector::zeros();
        up[D - 1] = 1.0;
        Self { point: pose.position.into(), normal: pose.rotate(&up) }
    }

    pub(crate) fn height(&self, x: &Vector<D>) -> f64 {
        self.normal.dot(&(x - self.point))
    }

    /// Least height of a point of a box.
    pub(crate) fn least(&self, aabb: &Aabb<D>) -> f64 {
        let lowest = Vector::from_fn(|i, _| if self.normal[i] > 0.0 { aabb.min[i] } else { aabb.max[i] });
        self.height(&lowest)
    }
}
