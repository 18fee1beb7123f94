//! A point on the boundary of one side of a pair.

use crate::geometry::Vector;

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

impl<const D: usize> SurfacePoint<D> {
    /// Whether it lies on a rigid shape without facets.
    pub(crate) fn is_of_shape(&self) -> bool {
        matches!(self, SurfacePoint::Point { .. })
    }
}
