//! A sample of the contact of two sides.

use crate::overlap::pair::surface_point::SurfacePoint;
use crate::ranks::packed;

/// A chord of the overlap, from boundary to boundary.
pub(crate) struct ContactSample<const D: usize> {
    pub(crate) ends: [SurfacePoint<D>; 2],
    /// Measure of boundary at either end for which the sample stands.
    pub(crate) measures: [f64; 2],
    /// From end to end.
    pub(crate) length: f64,
}

packed!(ContactSample<D> { ends, measures, length });
