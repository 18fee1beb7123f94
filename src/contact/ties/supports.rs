//! What a host holds of the coordinates.

use crate::geometry::Surface;
use std::sync::Arc;

/// Coordinates that supports hold; none where nothing is known of them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Supports {
    /// By row and axis; empty: none.
    held: Arc<[bool]>,
}

impl Supports {
    pub(crate) fn new(held: impl Iterator<Item = bool>) -> Self {
        Self { held: held.collect() }
    }

    /// Whether they hold a point of the mesh along an axis: all rows that move it.
    pub(crate) fn hold<const D: usize>(&self, surface: &Surface<D>, point: u32, axis: usize) -> bool {
        let is_held = |row: u32| self.held[row as usize * D + axis];
        match surface.division() {
            _ if self.held.is_empty() => false,
            Some(division) => division.map().row(point as usize).all(|(row, weight)| weight == 0.0 || is_held(row)),
            None => is_held(point),
        }
    }
}
