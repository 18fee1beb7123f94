//! A cone about the last axis: apex at `+half_height`, base at `−half_height`; in 2D an isosceles triangle.

use super::chord::{Chord, Hit, common, everywhere, slab};
use super::convex_shape::ConvexShape;
use super::extent::Extent;
use super::faces::positive;
#[cfg(feature = "shapes")]
use super::nearest::{Nearest, PLANE, UPRIGHT, by_parry, polyline};
use super::revolution::{radial, turned};
use crate::Error;
use crate::geometry::Vector;

pub(super) struct Cone {
    radius: f64,
    half_height: f64,
}

impl Cone {
    pub(super) fn new(radius: f64, half_height: f64) -> Result<Self, Error> {
        Ok(Self { radius: positive("radius", radius)?, half_height: positive("half_height", half_height)? })
    }
}

impl<const D: usize> ConvexShape<D> for Cone {
    fn extent(&self) -> Extent<D> {
        Extent::about_axis(self.radius, self.half_height, self.radius.hypot(self.half_height))
    }

    fn chord(&self, o: &Vector<D>, d: &Vector<D>) -> Chord<D> {
        common(nappe(o, d, self.radius, self.half_height), slab(o, d, D - 1, -self.half_height, self.half_height))
    }

    fn signed_distance(&self, x: &Vector<D>) -> (f64, Vector<D>) {
        turned(x, |x| section(x, self.radius, self.half_height))
    }

    fn distance_bound(&self, x: &Vector<D>) -> f64 {
        let (height, half_height) = (x[D - 1], self.half_height);
        // The lateral surface, endless.
        let slope = self.radius / (2.0 * half_height);
        let lateral = (radial(x) - slope * (half_height - height)) / slope.hypot(1.0);
        lateral.max(height.abs() - half_height)
    }

    #[cfg(feature = "shapes")]
    fn nearest(&self) -> Option<Nearest<D>> {
        let (radius, half_height) = (self.radius, self.half_height);
        let point = if D == 3 {
            by_parry!(parry3d_f64, 3, UPRIGHT, parry3d_f64::shape::Cone::new(half_height, radius))
        } else {
            let corners = [[-radius, -half_height], [radius, -half_height], [0.0, half_height]];
            let (line, edges) = (corners.map(Into::into).to_vec(), vec![[0, 1], [1, 2], [2, 0]]);
            by_parry!(parry2d_f64, 2, PLANE, polyline(line, edges))
        };
        Some(Nearest { point, least: radius.min(half_height) })
    }
}

/// The chord in the lower nappe of the endless cone with its apex at `half_height` and the given radius at
/// `−half_height`.
fn nappe<const D: usize>(o: &Vector<D>, d: &Vector<D>, radius: f64, half_height: f64) -> Chord<D> {
    // f(x) = |radial|² − k² (h − z)² ≤ 0, on the line A t² + 2 B t + C.
    let k2 = (radius / (2.0 * half_height)).powi(2);
    let (mut or, mut dr) = (*o, *d);
    (or[D - 1], dr[D - 1]) = (0.0, 0.0);
    let (depth, dz) = (half_height - o[D - 1], d[D - 1]);
    let mut a = dr.norm_squared() - k2 * dz * dz;
    let b = or.dot(&dr) + k2 * depth * dz;
    let c = or.norm_squared() - k2 * depth * depth;
    if a.abs() < 1e-14 * (1.0 + k2) {
        // Parallel to a generator: a line turned by less than rounding meets the same points.
        a = 1e-14 * (1.0 + k2);
    }
    let discriminant = b * b - a * c;
    if discriminant < 0.0 && a > 0.0 {
        return None;
    }
    let q = -(b + b.signum() * discriminant.max(0.0).sqrt());
    let roots = if q == 0.0 { [0.0, 0.0] } else { [q / a, c / q] };
    let at = |t: f64| {
        let x = o + d * t;
        let mut normal = x;
        normal[D - 1] = k2 * (half_height - x[D - 1]);
        Hit { t, normal: normal.try_normalize(0.0).unwrap_or_else(Vector::zeros) }
    };
    let (first, last) = (roots[0].min(roots[1]), roots[0].max(roots[1]));
    match a {
        a if a > 0.0 => Some([at(first), at(last)]),
        // Steeper than the cone: it runs in one nappe up to one root and in the other from the other root on.
        _ if dz > 0.0 => Some([everywhere(f64::NEG_INFINITY), at(first)]),
        _ => Some([at(last), everywhere(f64::INFINITY)]),
    }
}

/// Distance and gradient in the half of the section, a triangle.
fn section(x: &Vector<2>, radius: f64, half_height: f64) -> (f64, Vector<2>) {
    let (apex, rim) = (Vector::<2>::new(0.0, half_height), Vector::<2>::new(radius, -half_height));
    let (lateral, base) = (Vector::<2>::new(2.0 * half_height, radius).normalize(), Vector::<2>::new(0.0, -1.0));
    let faces = [(lateral, lateral.dot(&(x - apex))), (base, -half_height - x[1])];
    let (normal, height) = if faces[0].1 >= faces[1].1 { faces[0] } else { faces[1] };
    if height <= 0.0 {
        return (height, normal);
    }
    let foot = Vector::<2>::new(0.0, -half_height);
    let from = [(apex, rim), (foot, rim)].map(|(p, q)| {
        let along = q - p;
        x - p - along * ((x - p).dot(&along) / along.norm_squared()).clamp(0.0, 1.0)
    });
    let from = if from[0].norm_squared() <= from[1].norm_squared() { from[0] } else { from[1] };
    let phi = from.norm();
    (phi, if phi > 0.0 { from / phi } else { normal })
}
