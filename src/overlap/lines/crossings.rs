//! The crossings of a bundle's fibers with both sides, fiber by fiber.

use super::bundle::Bundle;
use super::sweep::Event;
use crate::configuration::FacetSide;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::crossing::{Window, for_each_crossing};
use crate::overlap::pair::sides::Counterpart;
use crate::sampling::Segment;
use std::ops::Range;

/// The events of every fiber of a bundle that meets both sides; fibers by number, events unsorted.
#[derive(Default)]
pub(crate) struct BundleEvents {
    pub(crate) fibers: Vec<LineEvents>,
    pub(crate) events: Vec<Event>,
}

/// One fiber: the winding number of each side before its first event, and its events.
pub(crate) struct LineEvents {
    pub(crate) fiber: u64,
    pub(crate) start: [i16; 2],
    pub(crate) events: Range<usize>,
}

impl<const D: usize> Bundle<'_, D> {
    /// All events of the fibers that meet both sides (of lines, those before the far end of the region).
    pub(crate) fn gather(&self, a: &FacetSide<D>, counterpart: &Counterpart<D>) -> BundleEvents {
        match self {
            Bundle::Lines { .. } => self.gather_lines(a, counterpart),
            Bundle::Segments { .. } => self.gather_segments(a, counterpart),
        }
    }

    fn gather_lines(&self, a: &FacetSide<D>, counterpart: &Counterpart<D>) -> BundleEvents {
        let Bundle::Lines { window, facets, reach, .. } = self else { return BundleEvents::default() };
        let b = if let Counterpart::Facets(b) = counterpart { Some(b) } else { None };
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
        let mut gathered = BundleEvents::default();
        let mut place = vec![u32::MAX; window.line_count()];
        let mut total = 0;
        for (line, (start, count)) in start.iter().zip(&count).enumerate() {
            let meets = |s: usize| count[s] > 0 || start[s] != 0;
            let events = (count[0] + count[1]) as usize;
            // An obstacle may lie between two crossings of the first side that are both outside the region.
            if if b.is_some() { meets(0) && meets(1) && events > 0 } else { meets(0) } {
                gathered.fibers.push(LineEvents { fiber: line as u64, start: *start, events: total..total + events });
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

    fn gather_segments(&self, a: &FacetSide<D>, counterpart: &Counterpart<D>) -> BundleEvents {
        let Bundle::Segments { seed, range, region, length, .. } = self else { return BundleEvents::default() };
        let b = if let Counterpart::Facets(b) = counterpart { Some(b) } else { None };
        let mut gathered = BundleEvents::default();
        for fiber in range.clone() {
            let segment = Segment::sample(*seed, fiber, region);
            let first = gathered.events.len();
            let mut start = [0i16; 2];
            // Both sides must cover the segment at its start or be crossed by it.
            let complete = [Some(a), b].into_iter().flatten().enumerate().all(|(s, side)| {
                let before = gathered.events.len();
                let accept = |b: &Aabb<D>| b.meets_ray(&segment.origin, segment.direction(), *length);
                side.tree.visit(accept, |facet| {
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
                gathered.fibers.push(LineEvents { fiber, start, events: first..gathered.events.len() });
            } else {
                gathered.events.truncate(first);
            }
        }
        gathered
    }

    /// Where the search for an obstacle along a fiber begins and ends, given the fiber's events on the first side.
    pub(crate) fn interval(&self, gathering: &LineEvents, events: &[Event]) -> [f64; 2] {
        let events = &events[gathering.events.clone()];
        let [low, high] = self.reach();
        let steps: i16 = events.iter().map(|e| if e.leaves { -1 } else { 1 }).sum();
        let first = events.iter().map(|e| e.t).fold(f64::INFINITY, f64::min);
        let last = events.iter().map(|e| e.t).fold(f64::NEG_INFINITY, f64::max);
        let covered_at_end = gathering.start[0] + steps != 0;
        [if gathering.start[0] != 0 { low } else { first }, if covered_at_end { high } else { last }]
    }
}
