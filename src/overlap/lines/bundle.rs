//! Bundles of fibers: the pieces in which a pair is worked off, in a fixed order whatever the number of threads.

use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::crossing::{Projected, Window};
use crate::sampling::{Family, Segment};
use std::ops::Range;
use std::sync::Mutex;

/// A piece of a pattern.
pub(crate) enum Bundle<'a, const D: usize> {
    /// Some lines of a family, as far as the region reaches along them; facets of each side.
    Lines { family: &'a Family<D>, index: usize, spacing: f64, window: Window, reach: [f64; 2], facets: [FacetList; 2] },
    /// Some isotropic segments.
    Segments {
        seed: u64,
        range: Range<u64>,
        region: &'a Aabb<D>,
        length: f64,
        /// The segment that was sampled last: what is asked of one segment is asked in a row.
        last: Mutex<Option<(u64, Segment<D>)>>,
    },
}

/// Facets of one side that the lines of a bundle may cross.
#[derive(Clone, Debug, Default)]
pub(crate) struct FacetList {
    /// In the region, or reaching into it.
    pub(crate) within: Vec<u32>,
    /// Before it: they only decide whether a line enters the region inside the body.
    pub(crate) before: Vec<u32>,
}

impl<const D: usize> Bundle<'_, D> {
    /// Number of fibers laid.
    pub(crate) fn fiber_count(&self) -> usize {
        match self {
            Bundle::Lines { window, .. } => window.line_count(),
            Bundle::Segments { range, .. } => (range.end - range.start) as usize,
        }
    }

    /// Index of its family; segments have none.
    pub(crate) fn family_index(&self) -> usize {
        if let Bundle::Lines { index, .. } = self { *index } else { 0 }
    }

    /// Length of the fibers, if they have ends.
    pub(crate) fn length(&self) -> Option<f64> {
        match self {
            Bundle::Lines { .. } => None,
            Bundle::Segments { length, .. } => Some(*length),
        }
    }

    /// Origin and direction of a fiber.
    pub(crate) fn ray(&self, fiber: u64) -> (Vector<D>, Vector<D>) {
        match self {
            Bundle::Lines { family, spacing, .. } => {
                let (i, j) = self.grid_point(fiber);
                (family.origin(i, j, *spacing), *family.direction())
            }
            Bundle::Segments { seed, region, last, .. } => {
                let segment = sampled(*seed, fiber, region, last);
                (segment.origin, *segment.direction())
            }
        }
    }

    /// Place of a fiber in the frame of [`Self::project`].
    pub(crate) fn grid_point(&self, fiber: u64) -> (i64, i64) {
        match self {
            Bundle::Lines { window, .. } => {
                let row = (window.i.end - window.i.start) as u64;
                (window.i.start + (fiber % row) as i64, window.j.start + (fiber / row) as i64)
            }
            Bundle::Segments { .. } => (0, 0),
        }
    }

    /// A facet as seen along a fiber.
    pub(crate) fn project(&self, side: &FacetSide<D>, facet: usize, fiber: u64) -> [Projected; D] {
        match self {
            Bundle::Lines { family, spacing, .. } => {
                let per_length = 1.0 / spacing;
                side.corners(facet).map(|x| family.on_grid(&family.view(&x), per_length))
            }
            Bundle::Segments { seed, region, last, .. } => {
                let segment = sampled(*seed, fiber, region, last);
                side.corners(facet).map(|x| segment.view(&x))
            }
        }
    }

    /// Between which `t` the events of its fibers lie.
    pub(crate) fn reach(&self) -> [f64; 2] {
        match self {
            Bundle::Lines { reach, .. } => *reach,
            Bundle::Segments { length, .. } => [0.0, *length],
        }
    }
}

/// A segment, sampled anew only if it is another than the last.
fn sampled<const D: usize>(
    seed: u64,
    fiber: u64,
    region: &Aabb<D>,
    last: &Mutex<Option<(u64, Segment<D>)>>,
) -> Segment<D> {
    let mut last = last.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    match *last {
        Some((number, segment)) if number == fiber => segment,
        _ => {
            let segment = Segment::sample(seed, fiber, region);
            *last = Some((fiber, segment));
            segment
        }
    }
}
