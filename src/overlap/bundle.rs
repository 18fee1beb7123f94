//! Bundles of fibers: the pieces in which a pair is worked off, in a fixed order whatever the number of threads.

use super::side::{FacetSide, Opponent};
use super::span::Event;
use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::crossing::{Projected, Window, ceil, for_each_crossing};
use crate::geometry::tree::Tree;
use crate::sampling::{Family, Segment};
use std::ops::Range;

/// Lines of a bundle. Large enough that the loop over facets is small beside the crossings, small enough that the
/// counters stay in the cache and that several threads share the work.
const LINES_PER_BUNDLE: usize = 1 << 14;

/// Segments of a bundle.
const SEGMENTS_PER_BUNDLE: u64 = 1 << 12;

/// A piece of a pattern.
pub(crate) enum Bundle<'a, const D: usize> {
    /// Some lines of a family, as far as the region reaches along them; facets of each side.
    Lines { family: &'a Family<D>, index: usize, spacing: f64, window: Window, reach: [f64; 2], facets: [Reached; 2] },
    /// Some isotropic segments.
    Segments { seed: u64, range: Range<u64>, region: &'a Aabb<D>, length: f64, trees: &'a [Tree<D>] },
}

/// Facets of one side that the lines of a bundle may cross.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reached {
    /// In the region, or reaching into it.
    within: Vec<u32>,
    /// Before it: they tell only whether a line enters the region inside the body.
    before: Vec<u32>,
}

/// The events of every fiber of a bundle that meets both sides; fibers by number, events unsorted.
#[derive(Default)]
pub(crate) struct Gathered {
    pub(crate) fibers: Vec<Gathering>,
    pub(crate) events: Vec<Event>,
}

/// One fiber: how often each side covers it before its first event, and its events.
pub(crate) struct Gathering {
    pub(crate) fiber: u64,
    pub(crate) start: [i16; 2],
    pub(crate) events: Range<usize>,
}

/// Cuts a family's window into bundles and gives each the facets that its lines may cross.
pub(crate) fn line_bundles<'a, const D: usize>(
    family: &'a Family<D>,
    index: usize,
    spacing: f64,
    region: &Aabb<D>,
    sides: [Option<&FacetSide<D>>; 2],
) -> Option<Vec<Bundle<'a, D>>> {
    let per_length = 1.0 / spacing;
    let (window, reach) = family.window(region, per_length)?;
    // The window in units of length, a line wider: most facets are dismissed by it.
    let (corner, far) = family.window_in_length(&window, spacing);
    let apart = |low: &Projected, high: &Projected| {
        (0..D - 1).any(|axis| low[axis] > far[axis] || high[axis] < corner[axis])
    };
    // Rows along v in 3D, single lines along u in 2D.
    let axis = usize::from(D == 3);
    let (across, along) = if D == 3 { (&window.j, &window.i) } else { (&window.i, &window.j) };
    let row = (along.end - along.start).max(1) as usize;
    let rows = (LINES_PER_BUNDLE / row).max(1) as i64;
    let count = ((across.end - across.start + rows - 1) / rows).max(0) as usize;
    let mut facets: Vec<[Reached; 2]> = (0..count).map(|_| Default::default()).collect();
    for (s, side) in sides.iter().enumerate() {
        let Some(side) = side else { continue };
        let viewed = &side.views.viewed[index];
        for (facet, vertices) in side.facets.iter().enumerate() {
            let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
            for &v in vertices {
                let p = &viewed[v as usize];
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
                let Reached { within, before: earlier } = &mut facets[bundle as usize][s];
                (if before { earlier } else { within }).push(facet as u32);
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
                let window = if D == 3 {
                    Window { i: window.i.clone(), j: part }
                } else {
                    Window { i: part, j: 0..1 }
                };
                Bundle::Lines { family, index, spacing, window, reach, facets }
            })
            .collect(),
    )
}

/// Cuts `count` segments into bundles.
pub(crate) fn segment_bundles<'a, const D: usize>(
    seed: u64,
    count: u64,
    region: &'a Aabb<D>,
    length: f64,
    trees: &'a [Tree<D>],
) -> Vec<Bundle<'a, D>> {
    (0..count)
        .step_by(SEGMENTS_PER_BUNDLE as usize)
        .map(|start| {
            let range = start..(start + SEGMENTS_PER_BUNDLE).min(count);
            Bundle::Segments { seed, range, region, length, trees }
        })
        .collect()
}

impl<const D: usize> Bundle<'_, D> {
    /// Number of fibers laid.
    pub(crate) fn fiber_count(&self) -> usize {
        match self {
            Bundle::Lines { window, .. } => window.line_count(),
            Bundle::Segments { range, .. } => (range.end - range.start) as usize,
        }
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
            Bundle::Segments { seed, region, .. } => {
                let segment = Segment::sample(*seed, fiber, region);
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
            Bundle::Lines { family, index, spacing, .. } => {
                let viewed = &side.views.viewed[*index];
                let per_length = 1.0 / spacing;
                let mut p = [[0.0; 3]; D];
                for (p, &v) in p.iter_mut().zip(&side.facets[facet]) {
                    *p = family.on_grid(&viewed[v as usize], per_length);
                }
                p
            }
            Bundle::Segments { seed, region, .. } => {
                let segment = Segment::sample(*seed, fiber, region);
                side.corners(facet).map(|x| segment.view(&x))
            }
        }
    }

    /// All events of the fibers that meet both sides (of lines, those before the far end of the region).
    pub(crate) fn gather(&self, a: &FacetSide<D>, opponent: &Opponent<D>) -> Gathered {
        match self {
            Bundle::Lines { .. } => self.gather_lines(a, opponent),
            Bundle::Segments { .. } => self.gather_segments(a, opponent),
        }
    }

    fn gather_lines(&self, a: &FacetSide<D>, opponent: &Opponent<D>) -> Gathered {
        let Bundle::Lines { window, facets, reach, .. } = self else { return Gathered::default() };
        let b = if let Opponent::Facets(b) = opponent { Some(b) } else { None };
        let mut start = vec![[0i16; 2]; window.line_count()];
        let mut count = vec![[0u32; 2]; window.line_count()];
        let mut raw: Vec<(u32, Event)> = Vec::new();
        for (s, side) in [Some(a), b].into_iter().enumerate() {
            let Some(side) = side else { continue };
            for &facet in &facets[s].before {
                self.rasterise(side, facet, window, |line, _, leaves| {
                    start[line as usize][s] += if leaves { -1 } else { 1 };
                });
            }
            for &facet in &facets[s].within {
                self.rasterise(side, facet, window, |line, t, leaves| {
                    // Whatever lies before the region is only counted, and what lies behind it is of no interest: what
                    // is left out of one body must not be met by an event of the other.
                    if t < reach[0] {
                        start[line as usize][s] += if leaves { -1 } else { 1 };
                    } else if t > reach[1] {
                    } else if s == 0 || count[line as usize][0] > 0 || start[line as usize][0] != 0 {
                        count[line as usize][s] += 1;
                        raw.push((line, Event { t, source: facet, of_b: s == 1, leaves }));
                    }
                });
            }
        }
        // Counting sort by line; `place` is where the line's next event goes.
        let mut gathered = Gathered::default();
        let mut place = vec![u32::MAX; window.line_count()];
        let mut total = 0;
        for (line, (start, count)) in start.iter().zip(&count).enumerate() {
            let meets = |s: usize| count[s] > 0 || start[s] != 0;
            let events = (count[0] + count[1]) as usize;
            // An obstacle may lie between two crossings of the first side that are both outside the region.
            if if b.is_some() { meets(0) && meets(1) && events > 0 } else { meets(0) } {
                gathered.fibers.push(Gathering { fiber: line as u64, start: *start, events: total..total + events });
                place[line] = total as u32;
                total += events;
            }
        }
        gathered.events = vec![Event { t: 0.0, source: 0, of_b: false, leaves: false }; total];
        for (line, event) in raw {
            let place = &mut place[line as usize];
            if *place != u32::MAX {
                gathered.events[*place as usize] = event;
                *place += 1;
            }
        }
        gathered
    }

    fn rasterise(&self, side: &FacetSide<D>, facet: u32, window: &Window, mut visit: impl FnMut(u32, f64, bool)) {
        let p = self.project(side, facet as usize, 0);
        for_each_crossing::<D>(std::array::from_fn(|k| &p[k]), window, |i, j, t, leaves| {
            visit(window.line(i, j), t, leaves);
        });
    }

    fn gather_segments(&self, a: &FacetSide<D>, opponent: &Opponent<D>) -> Gathered {
        let Bundle::Segments { seed, range, region, length, trees } = self else { return Gathered::default() };
        let b = if let Opponent::Facets(b) = opponent { Some(b) } else { None };
        let mut gathered = Gathered::default();
        for fiber in range.clone() {
            let segment = Segment::sample(*seed, fiber, region);
            let first = gathered.events.len();
            let mut start = [0i16; 2];
            // Both sides must cover the segment at its start or be crossed by it.
            let complete = [Some(a), b].into_iter().flatten().enumerate().all(|(s, side)| {
                let before = gathered.events.len();
                let accept = |b: &Aabb<D>| b.meets_ray(&segment.origin, segment.direction(), *length);
                trees[s].visit(accept, |facet| {
                    let p = side.corners(facet as usize).map(|x| segment.view(&x));
                    for_each_crossing::<D>(std::array::from_fn(|k| &p[k]), &Window::single(), |_, _, t, leaves| {
                        if t < 0.0 {
                            start[s] += if leaves { -1 } else { 1 };
                        } else if t <= *length {
                            gathered.events.push(Event { t, source: facet, of_b: s == 1, leaves });
                        }
                    });
                });
                start[s] != 0 || gathered.events.len() > before
            });
            if complete {
                gathered.fibers.push(Gathering { fiber, start, events: first..gathered.events.len() });
            } else {
                gathered.events.truncate(first);
            }
        }
        gathered
    }

    /// Between which `t` the events of its fibers lie.
    pub(crate) fn reach(&self) -> [f64; 2] {
        match self {
            Bundle::Lines { reach, .. } => *reach,
            Bundle::Segments { length, .. } => [0.0, *length],
        }
    }

    /// Where the search for an obstacle along a fiber begins and ends, given the fiber's events on the first side.
    pub(crate) fn stretch(&self, gathering: &Gathering, events: &[Event]) -> [f64; 2] {
        let events = &events[gathering.events.clone()];
        let [low, high] = self.reach();
        let steps: i16 = events.iter().map(|e| if e.leaves { -1 } else { 1 }).sum();
        let first = events.iter().map(|e| e.t).fold(f64::INFINITY, f64::min);
        let last = events.iter().map(|e| e.t).fold(f64::NEG_INFINITY, f64::max);
        let covered_at_end = gathering.start[0] + steps != 0;
        [if gathering.start[0] != 0 { low } else { first }, if covered_at_end { high } else { last }]
    }
}
