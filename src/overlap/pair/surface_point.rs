//! A point on the boundary of one side of a pair.

use crate::geometry::Vector;
use crate::ranks::Packed;

/// One end of a span.
#[derive(Clone, Copy, Debug)]
pub(crate) enum SurfacePoint<const D: usize> {
    /// On a facet of one of the sides, at barycentric coordinates `weights`.
    Facet {
        /// Whether the facet is of the second side.
        of_b: bool,
        /// Index within the side.
        facet: u32,
        /// Barycentric coordinates.
        weights: [f64; D],
    },
    /// On a rigid shape without facets.
    Point {
        /// Where.
        point: Vector<D>,
        /// Unit outward normal.
        normal: Vector<D>,
    },
}

impl<const D: usize> Packed for SurfacePoint<D> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        match self {
            SurfacePoint::Facet { of_b, facet, weights } => (true, (*of_b, *facet, *weights)).pack(bytes),
            SurfacePoint::Point { point, normal } => (false, (*point, *normal)).pack(bytes),
        }
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        Some(match bool::unpack(bytes)? {
            true => {
                let (of_b, facet, weights) = Packed::unpack(bytes)?;
                SurfacePoint::Facet { of_b, facet, weights }
            }
            false => {
                let (point, normal) = Packed::unpack(bytes)?;
                SurfacePoint::Point { point, normal }
            }
        })
    }

    fn blank() -> Self {
        SurfacePoint::Point { point: Vector::zeros(), normal: Vector::zeros() }
    }
}

impl<const D: usize> SurfacePoint<D> {
    /// Whether it lies on a rigid shape without facets.
    pub(crate) fn is_of_shape(&self) -> bool {
        matches!(self, SurfacePoint::Point { .. })
    }
}
