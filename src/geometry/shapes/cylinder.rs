//! A cylinder about the last axis, centred; in 2D a rectangle.

use super::chord::{Chord, common, quadric, slab};
use super::convex_shape::ConvexShape;
use super::cuboid::distance_from_box;
use super::extent::Extent;
use super::faces::positive;
#[cfg(feature = "shapes")]
use super::nearest::{Nearest, PLANE, UPRIGHT, by_parry};
use super::revolution::{radial, turned};
use crate::Error;
use crate::geometry::Vector;
use std::sync::Arc;

pub(super) struct Cylinder {
    radius: f64,
    half_height: f64,
}

impl Cylinder {
    pub(super) fn new(radius: f64, half_height: f64) -> Result<Self, Error> {
        Ok(Self { radius: positive("radius", radius)?, half_height: positive("half_height", half_height)? })
    }
}

impl<const D: usize> ConvexShape<D> for Cylinder {
    fn extent(&self) -> Extent<D> {
        Extent::about_axis(self.radius, self.half_height, self.radius.hypot(self.half_height))
    }

    fn chord(&self, o: &Vector<D>, d: &Vector<D>) -> Chord<D> {
        common(quadric(o, d, 0.0, self.radius), slab(o, d, D - 1, -self.half_height, self.half_height))
    }

    fn signed_distance(&self, x: &Vector<D>) -> (f64, Vector<D>) {
        turned(x, |x| distance_from_box(x, &Vector::<2>::new(self.radius, self.half_height)))
    }

    fn distance_bound(&self, x: &Vector<D>) -> f64 {
        (radial(x) - self.radius).max(x[D - 1].abs() - self.half_height)
    }

    /// Inwards edges stay sharp; outwards they become round.
    fn parallel(&self, offset: f64) -> Option<Arc<dyn ConvexShape<D>>> {
        if offset >= 0.0 {
            return None;
        }
        Some(Arc::new(Cylinder::new(self.radius + offset, self.half_height + offset).ok()?))
    }

    #[cfg(feature = "shapes")]
    fn nearest(&self) -> Option<Nearest<D>> {
        let (radius, half_height) = (self.radius, self.half_height);
        let point = if D == 2 {
            by_parry!(parry2d_f64, 2, PLANE, parry2d_f64::shape::Cuboid::new([radius, half_height].into()))
        } else {
            by_parry!(parry3d_f64, 3, UPRIGHT, parry3d_f64::shape::Cylinder::new(half_height, radius))
        };
        Some(Nearest { point, least: radius.min(half_height) })
    }
}
