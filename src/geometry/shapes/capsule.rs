//! All points within a radius of a segment of the last axis; in 2D a stadium.

use super::chord::{Chord, common, hull, quadric, slab};
use super::convex_shape::ConvexShape;
use super::extent::Extent;
use super::faces::positive;
#[cfg(feature = "shapes")]
use super::nearest::{Nearest, PLANE, UPRIGHT, by_parry};
use super::revolution::{radial, turned};
use crate::Error;
use crate::geometry::Vector;
use std::sync::Arc;

pub(super) struct Capsule {
    radius: f64,
    half_height: f64,
}

impl Capsule {
    pub(super) fn new(radius: f64, half_height: f64) -> Result<Self, Error> {
        Ok(Self { radius: positive("radius", radius)?, half_height: positive("half_height", half_height)? })
    }
}

impl<const D: usize> ConvexShape<D> for Capsule {
    fn extent(&self) -> Extent<D> {
        Extent::about_axis(self.radius, self.half_height + self.radius, self.radius + self.half_height)
    }

    fn chord(&self, o: &Vector<D>, d: &Vector<D>) -> Chord<D> {
        let &Self { radius, half_height } = self;
        let mut up = Vector::zeros();
        up[D - 1] = half_height;
        let side = common(quadric(o, d, 0.0, radius), slab(o, d, D - 1, -half_height, half_height));
        [side, quadric(&(o - up), d, 1.0, radius), quadric(&(o + up), d, 1.0, radius)]
            .into_iter()
            .reduce(hull)
            .flatten()
    }

    fn signed_distance(&self, x: &Vector<D>) -> (f64, Vector<D>) {
        turned(x, |x| {
            let from = Vector::<2>::new(x[0], x[1] - x[1].clamp(-self.half_height, self.half_height));
            let distance = from.norm();
            let gradient = if distance > 0.0 { from / distance } else { Vector::<2>::new(1.0, 0.0) };
            (distance - self.radius, gradient)
        })
    }

    fn distance_bound(&self, x: &Vector<D>) -> f64 {
        radial(x).hypot((x[D - 1].abs() - self.half_height).max(0.0)) - self.radius
    }

    fn parallel(&self, offset: f64) -> Option<Arc<dyn ConvexShape<D>>> {
        Some(Arc::new(Capsule::new(self.radius + offset, self.half_height).ok()?))
    }

    #[cfg(feature = "shapes")]
    fn nearest(&self) -> Option<Nearest<D>> {
        let (radius, half_height) = (self.radius, self.half_height);
        let point = if D == 2 {
            by_parry!(parry2d_f64, 2, PLANE, parry2d_f64::shape::Capsule::new_y(half_height, radius))
        } else {
            by_parry!(parry3d_f64, 3, UPRIGHT, parry3d_f64::shape::Capsule::new_y(half_height, radius))
        };
        Some(Nearest { point, least: radius })
    }
}
