//! Isotropic segments: the paper's fibers (appendix A).

use super::stream::uniforms;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::crossing::Projected;

/// Stream of the segments: 0 … 2 belong to the standard families, 64 and above to those of patches.
const OF_SEGMENTS: u64 = 8;

/// A segment from `origin` along `axes[D − 1]`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Segment<const D: usize> {
    pub(crate) origin: Vector<D>,
    axes: [Vector<D>; D],
}

impl<const D: usize> Segment<D> {
    /// Segment number `index`: start uniform in `region`, direction uniform on the circle or sphere.
    pub(crate) fn sample(seed: u64, index: u64, region: &Aabb<D>) -> Self {
        let random = uniforms::<5>(seed, OF_SEGMENTS, index);
        let extent = region.extent();
        let origin = Vector::from_fn(|axis, _| region.min[axis] + extent[axis] * random[axis]);
        let (s, c) = (std::f64::consts::TAU * random[3]).sin_cos();
        let mut axes = [Vector::zeros(); D];
        if D == 2 {
            (axes[0][0], axes[0][1]) = (s, -c);
            (axes[1][0], axes[1][1]) = (c, s);
        } else {
            let z = 2.0 * random[4] - 1.0;
            let r = (1.0 - z * z).max(0.0).sqrt();
            (axes[2][0], axes[2][1], axes[2][2]) = (r * c, r * s, z);
            (axes[0][0], axes[0][1]) = (-s, c);
            (axes[1][0], axes[1][1], axes[1][2]) = (-z * c, -z * s, r);
        }
        Self { origin, axes }
    }

    /// Unit direction.
    pub(crate) fn direction(&self) -> &Vector<D> {
        &self.axes[D - 1]
    }

    /// A point across and along the segment.
    pub(crate) fn view(&self, x: &Vector<D>) -> Projected {
        let y = x - self.origin;
        let v = if D == 2 { 0.0 } else { y.dot(&self.axes[1]) };
        [y.dot(&self.axes[0]), v, y.dot(self.direction())]
    }
}
