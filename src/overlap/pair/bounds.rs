//! Planes between which the overlap of a pair lies.

use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;

/// Half-spaces `normal · x ≤ level` that hold all of an overlap.
pub(crate) struct Bounds<const D: usize>(pub(super) Vec<(Vector<D>, f64)>);

impl<const D: usize> Bounds<D> {
    /// False only if they hold no part of the convex hull of these points.
    pub(crate) fn may_hold(&self, points: impl Iterator<Item = Vector<D>> + Clone) -> bool {
        self.0.iter().all(|(normal, level)| points.clone().any(|x| normal.dot(&x) <= *level))
    }

    /// Box around the part of a simplex, or of a facet, that they hold, or a larger one; empty only if there is none.
    pub(crate) fn box_of_part(&self, corners: &[Vector<D>]) -> Aabb<D> {
        let mut all = Aabb::of(corners);
        let mut heights = [0.0; 4];
        for (normal, level) in &self.0 {
            let mut highest = f64::NEG_INFINITY;
            for (height, x) in heights.iter_mut().zip(corners) {
                *height = normal.dot(x) - level;
                highest = highest.max(*height);
            }
            if highest <= 0.0 {
                continue;
            }
            let mut part = Aabb::empty();
            for (k, x) in corners.iter().enumerate() {
                if heights[k] <= 0.0 {
                    part.include(x);
                }
                for (j, y) in corners[..k].iter().enumerate() {
                    if (heights[j] < 0.0) != (heights[k] < 0.0) {
                        part.include(&(y + (x - y) * (heights[j] / (heights[j] - heights[k]))));
                    }
                }
            }
            all = all.intersection(&part);
        }
        all
    }
}
