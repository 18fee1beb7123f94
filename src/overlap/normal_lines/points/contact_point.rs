//! A contact point.

use crate::overlap::pair::surface_point::SurfacePoint;
use crate::ranks::packed;

/// A piece of a line inside both sides.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ContactPoint<const D: usize> {
    /// Measure across the line that it stands for, times the part of it that counts for the line's direction.
    pub(crate) weight: f64,
    /// The same without the part.
    pub(crate) across: f64,
    /// Length, at least 0.
    pub(crate) length: f64,
    /// Index of the line's direction.
    pub(crate) direction: u32,
    /// Where the line enters and where it leaves.
    pub(crate) ends: [SurfacePoint<D>; 2],
}

packed!(ContactPoint<D> { weight, across, length, direction, ends });
