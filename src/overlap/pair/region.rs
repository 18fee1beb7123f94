//! Where two bodies can overlap.

use super::bounds::Bounds;
use super::main_normal::MainNormal;
use crate::geometry::primitives::aabb::Aabb;
use std::sync::OnceLock;

/// Where two bodies can overlap, and the facets of each that reach there.
pub(crate) struct Region<const D: usize> {
    pub(crate) aabb: Aabb<D>,
    pub(crate) facets: [Vec<u32>; 2],
    /// What a pair finds out about it when it is asked for first.
    pub(super) is_upright: OnceLock<bool>,
    pub(super) main_normal: OnceLock<Option<MainNormal<D>>>,
    pub(super) bounds: OnceLock<Bounds<D>>,
}

impl<const D: usize> Region<D> {
    pub(crate) fn new(aabb: Aabb<D>, facets: [Vec<u32>; 2]) -> Self {
        let (is_upright, main_normal, bounds) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        Self { aabb, facets, is_upright, main_normal, bounds }
    }
}
