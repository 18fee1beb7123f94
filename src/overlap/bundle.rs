//! Bundles of fibers: the pieces in which a pair is worked off, in a fixed order whatever the number of threads.

use super::side::{FacetSide, Opponent};
use super::span::Event;
use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::crossing::{Projected, Window, for_each_crossing};
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
    /// Some lines of a family.
    Lines { family: &'a Family<D>, index: usize, spacing: f64, window: Window, facets: [Vec<u32>; 2] },
    /// Some isotropic segments.
    Segments { seed: u64, range: Range<u64>, region: &'a Aabb<D>, length: f64, trees: &'a [Tree<D>] },
}

/// The events of every fiber of a bundle that meets both sides; fibers by number, events unsorted.
#[derive(Default)]
pub(crate) struct Gathered {
    pub(crate) fibers: Vec<(u64, Range<usize>)>,
    pub(crate) events: Vec<Event>,
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
    let (window, t_max) = family.window(region, per_length)?;
    // Rows along v in 3D, single lines along u in 2D.
    let axis = usize::from(D == 3);
    let (across, along) = if D == 3 { (&window.j, &window.i) } else { (&window.i, &window.j) };
    let row = (along.end - along.start).max(1) as usize;
    let rows = (LINES_PER_BUNDLE / row).max(1) as i64;
    let count = ((across.end - across.start + rows - 1) / rows).max(0) as usize;
    let mut facets: Vec<[Vec<u32>; 2]> = (0..count).map(|_| Default::default()).collect();
    for (s, side) in sides.iter().enumerate() {
        let Some(side) = side else { continue };
        let viewed = &side.views.viewed[index];
        for (facet, vertices) in side.facets.iter().enumerate() {
            let (mut low, mut high, mut t) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2], f64::INFINITY);
            for &v in vertices {
                let p = &viewed[v as usize];
                for axis in 0..D - 1 {
                    low[axis] = low[axis].min(p[axis]);
                    high[axis] = high[axis].max(p[axis]);
                }
                t = t.min(p[2]);
            }
            if t > t_max {
                continue;
            }
            let low = family.on_grid(&[low[0], low[1], t], per_length);
            let high = family.on_grid(&[high[0], high[1], t], per_length);
            let (first, last) = (low.map(|x| x.ceil() as i64), high.map(|x| x.ceil() as i64));
            if first[0] >= window.i.end || last[0] <= window.i.start || first[0] == last[0] {
                continue;
            }
            if D == 3 && (first[1] >= window.j.end || last[1] <= window.j.start || first[1] == last[1]) {
                continue;
            }
            let start = (first[axis].max(across.start) - across.start) / rows;
            let end = (last[axis].min(across.end) - 1 - across.start) / rows;
            for bundle in start..=end {
                facets[bundle as usize][s].push(facet as u32);
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
                Bundle::Lines { family, index, spacing, window, facets }
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
                side.facets[facet].map(|v| family.on_grid(&viewed[v as usize], 1.0 / spacing))
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
        let Bundle::Lines { window, facets, .. } = self else { return Gathered::default() };
        const MET_A: u32 = 1;
        let mut raw: Vec<(u32, Event)> = Vec::new();
        let mut met = vec![0u32; window.line_count()];
        let mut rasterise = |side: &FacetSide<D>, of_b: bool, met: &mut [u32]| {
            for &facet in &facets[usize::from(of_b)] {
                let p = self.project(side, facet as usize, 0);
                for_each_crossing::<D>(std::array::from_fn(|k| &p[k]), window, |i, j, t, leaves| {
                    let line = window.line(i, j);
                    let met = &mut met[line as usize];
                    // Lines that do not meet the first side are of no interest to the second.
                    if of_b && *met == 0 {
                        return;
                    }
                    *met |= if of_b { 2 } else { MET_A };
                    raw.push((line, Event { t, source: facet, of_b, leaves }));
                });
            }
        };
        rasterise(a, false, &mut met);
        let wanted = match opponent {
            Opponent::Facets(b) => {
                rasterise(b, true, &mut met);
                3
            }
            Opponent::Itself | Opponent::Implicit(_) => MET_A,
        };
        // Counting sort by line: `met` becomes the number of events, then the place of the next one.
        let is_wanted: Vec<bool> = met.iter().map(|&m| m == wanted).collect();
        met.fill(0);
        for (line, _) in &raw {
            if is_wanted[*line as usize] {
                met[*line as usize] += 1;
            }
        }
        let mut gathered = Gathered::default();
        let mut total = 0;
        for (line, place) in met.iter_mut().enumerate() {
            if *place > 0 {
                gathered.fibers.push((line as u64, total..total + *place as usize));
                (*place, total) = (total as u32, total + *place as usize);
            }
        }
        gathered.events = vec![Event { t: 0.0, source: 0, of_b: false, leaves: false }; total];
        for (line, event) in raw {
            if is_wanted[line as usize] {
                gathered.events[met[line as usize] as usize] = event;
                met[line as usize] += 1;
            }
        }
        gathered
    }

    fn gather_segments(&self, a: &FacetSide<D>, opponent: &Opponent<D>) -> Gathered {
        let Bundle::Segments { seed, range, region, length, trees } = self else { return Gathered::default() };
        let sides = [Some(a), if let Opponent::Facets(b) = opponent { Some(b) } else { None }];
        let mut gathered = Gathered::default();
        for fiber in range.clone() {
            let segment = Segment::sample(*seed, fiber, region);
            let start = gathered.events.len();
            let complete = sides.iter().flatten().enumerate().all(|(s, side)| {
                let before = gathered.events.len();
                let accept = |b: &Aabb<D>| b.meets_ray(&segment.origin, segment.direction(), *length);
                trees[s].visit(accept, |facet| {
                    let p = side.corners(facet as usize).map(|x| segment.view(&x));
                    for_each_crossing::<D>(std::array::from_fn(|k| &p[k]), &Window::single(), |_, _, t, leaves| {
                        if t <= *length {
                            gathered.events.push(Event { t, source: facet, of_b: s == 1, leaves });
                        }
                    });
                });
                gathered.events.len() > before
            });
            if complete {
                gathered.fibers.push((fiber, start..gathered.events.len()));
            } else {
                gathered.events.truncate(start);
            }
        }
        gathered
    }
}
