//! Where and how densely the fibers of a pair are laid.

use super::bundle::{Bundle, FacetList};
use super::resolution::{MOST_FIBERS, facet_size, line_spacing, segment_count};
use crate::Error;
use crate::configuration::FacetSide;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::crossing::{Projected, Window, ceil};
use crate::overlap::pair::options::FiberOptions;
use crate::overlap::pair::sides::{Counterpart, Pair};
use crate::sampling::{Family, FiberPattern};
use std::sync::Mutex;

/// Lines of a bundle. Large enough that the loop over facets is small beside the crossings, small enough that the
/// counters stay in the cache and that several threads share the work.
const LINES_PER_BUNDLE: usize = 1 << 14;

/// Segments of a bundle.
const SEGMENTS_PER_BUNDLE: u64 = 1 << 12;

/// A pair that is to be measured by fibers.
pub(crate) struct FiberPair<'a, const D: usize> {
    pub(crate) pair: &'a Pair<'a, D>,
    pub(crate) families: &'a [Family<D>],
    pub(crate) options: &'a FiberOptions,
}

/// How the bundles of a pair are laid.
pub(crate) struct Layout<'a, const D: usize> {
    pub(crate) region: Aabb<D>,
    pub(crate) facet_size: f64,
    /// Crossings nearer than this are one place.
    pub(crate) tolerance: f64,
    pub(crate) spacing: f64,
    /// Volume per unit length of a fiber, were its family (or the segments) the only one.
    pub(crate) volume_per_length: f64,
    pub(crate) bundles: Vec<Bundle<'a, D>>,
}

impl<const D: usize> FiberPair<'_, D> {
    /// Calls `work` with the layout, or returns `None` where the sides are apart. Lines lie `coarser` times as far
    /// apart as the options say.
    pub(crate) fn with_layout<T>(
        &self,
        coarser: f64,
        work: impl FnOnce(&Layout<D>) -> Result<T, Error>,
    ) -> Result<Option<T>, Error> {
        let Some(region) = self.pair.region()? else { return Ok(None) };
        let (facets, region) = (&region.facets, region.aabb);
        let b = if let Counterpart::Facets(b) = &self.pair.counterpart { Some(b) } else { None };
        let sizes = [Some(&self.pair.a), b].into_iter().flatten().zip(facets).map(|(s, f)| facet_size(s, f));
        let facet_size = sizes.fold(f64::INFINITY, f64::min);
        let facet_size = if facet_size.is_finite() { facet_size } else { region.extent().max() };
        let tolerance = region.rounding();
        match self.options.pattern {
            FiberPattern::Lines => {
                let &FiberOptions { resolution, weights, .. } = self.options;
                let spacing = coarser * line_spacing(resolution, self.families, &region, facet_size, weights)?;
                let mut bundles = Vec::new();
                for (index, family) in self.families.iter().enumerate() {
                    let of_family = line_bundles(family, index, spacing, &region, [Some(&self.pair.a), b]);
                    bundles.extend(of_family.ok_or(Error::TooManyFibers { needed: 1e15, limit: MOST_FIBERS })?);
                }
                let volume_per_length = spacing.powi(D as i32 - 1);
                work(&Layout { region, facet_size, tolerance, spacing, volume_per_length, bundles }).map(Some)
            }
            FiberPattern::Isotropic { length } => {
                let length = length.unwrap_or(facet_size);
                // Fibers that start within one length of the region reach it from all sides with uniform density.
                let starts = region.inflated(length);
                let count = segment_count(self.options.resolution, &starts, facet_size)?;
                let bundles = segment_bundles(self.options.seed, count, &starts, length);
                let volume_per_length = starts.volume() / (count as f64 * length);
                if !volume_per_length.is_finite() {
                    let quantity = "volume in which fibers of that length start";
                    return Err(Error::Overflow { quantity, value: starts.volume() });
                }
                work(&Layout { region, facet_size, tolerance, spacing: length, volume_per_length, bundles }).map(Some)
            }
        }
    }
}

/// Cuts a family's window into bundles and gives each the facets that its lines may cross.
fn line_bundles<'a, const D: usize>(
    family: &'a Family<D>,
    index: usize,
    spacing: f64,
    region: &Aabb<D>,
    sides: [Option<&FacetSide<D>>; 2],
) -> Option<Vec<Bundle<'a, D>>> {
    let per_length = 1.0 / spacing;
    let (window, reach) = family.window(region, per_length)?;
    if window.line_count() == 0 {
        return Some(Vec::new());
    }
    // The window in units of length, a line wider: most facets are dismissed by it.
    let (corner, far) = family.window_in_length(&window, spacing);
    let apart =
        |low: &Projected, high: &Projected| (0..D - 1).any(|axis| low[axis] > far[axis] || high[axis] < corner[axis]);
    // Rows along v in 3D, single lines along u in 2D.
    let axis = usize::from(D == 3);
    let (across, along) = if D == 3 { (&window.j, &window.i) } else { (&window.i, &window.j) };
    let row = (along.end - along.start).max(1) as usize;
    let rows = (LINES_PER_BUNDLE / row).max(1) as i64;
    let count = ((across.end - across.start + rows - 1) / rows).max(0) as usize;
    let mut facets: Vec<[FacetList; 2]> = (0..count).map(|_| Default::default()).collect();
    for (s, side) in sides.iter().enumerate() {
        let Some(side) = side else { continue };
        let met = side.facets_where(|aabb| {
            let [low, high] = family.view_box(aabb);
            low[2] <= reach[1] && !apart(&low, &high)
        });
        for facet in met {
            let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
            for x in side.corners(facet as usize) {
                let p = family.view(&x);
                for axis in 0..3 {
                    low[axis] = low[axis].min(p[axis]);
                    high[axis] = high[axis].max(p[axis]);
                }
            }
            if low[2] > reach[1] || apart(&low, &high) {
                continue;
            }
            let before = high[2] < reach[0];
            let low = family.on_grid(&low, per_length);
            let high = family.on_grid(&high, per_length);
            let (first, last) = ([ceil(low[0]), ceil(low[1])], [ceil(high[0]), ceil(high[1])]);
            if first[0] >= window.i.end || last[0] <= window.i.start || first[0] == last[0] {
                continue;
            }
            if D == 3 && (first[1] >= window.j.end || last[1] <= window.j.start || first[1] == last[1]) {
                continue;
            }
            let start = (first[axis].max(across.start) - across.start) / rows;
            let end = (last[axis].min(across.end) - 1 - across.start) / rows;
            for bundle in start..=end {
                let FacetList { within, before: earlier } = &mut facets[bundle as usize][s];
                (if before { earlier } else { within }).push(facet);
            }
        }
    }
    Some(
        facets
            .into_iter()
            .enumerate()
            .map(|(n, facets)| {
                let start = across.start + n as i64 * rows;
                let part = start..(start + rows).min(across.end);
                let window = if D == 3 { Window { i: window.i.clone(), j: part } } else { Window { i: part, j: 0..1 } };
                Bundle::Lines { family, index, spacing, window, reach, facets }
            })
            .collect(),
    )
}

/// Cuts `count` segments into bundles.
fn segment_bundles<'a, const D: usize>(seed: u64, count: u64, region: &'a Aabb<D>, length: f64) -> Vec<Bundle<'a, D>> {
    (0..count)
        .step_by(SEGMENTS_PER_BUNDLE as usize)
        .map(|start| {
            let range = start..(start + SEGMENTS_PER_BUNDLE).min(count);
            Bundle::Segments { seed, range, region, length, last: Mutex::new(None) }
        })
        .collect()
}
