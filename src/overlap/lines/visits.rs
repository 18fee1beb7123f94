//! Every fiber of a pair with its crossings, in a fixed order.

use super::bundle::Bundle;
use super::crossings::LineEvents;
use super::layout::{FiberPair, Layout};
use super::obstacle_crossings::intersections;
use super::sweep::{Event, sort};
use crate::Error;
use crate::geometry::{Intersection, Vector};
use crate::overlap::pair::options::LineWeights;
use crate::overlap::pair::sides::Counterpart;
use crate::ranks::Packed;
use crate::sampling::FiberPattern;

impl<const D: usize> FiberPair<'_, D> {
    /// Results in the order of the bundles. A signed distance function is called from this thread only.
    pub(crate) fn for_each_bundle<T: Packed + Send>(
        &self,
        layout: &Layout<D>,
        work: impl Fn(&Bundle<D>) -> Result<T, Error> + Sync,
    ) -> Result<Vec<T>, Error> {
        let found = self.pair.in_chunks(&layout.bundles, 1, |bundle| work(&bundle[0]));
        found.into_iter().collect()
    }

    /// Calls `visit(fiber, cover at its start, sorted events, passages)` for every fiber that may meet both sides.
    pub(crate) fn visit_fibers(
        &self,
        bundle: &Bundle<D>,
        layout: &Layout<D>,
        mut visit: impl FnMut(u64, [i16; 2], &[Event], &[Intersection<D>]),
    ) -> Result<(), Error> {
        let mut gathered = bundle.gather(&self.pair.a, &self.pair.counterpart);
        let Counterpart::Implicit(side) = &self.pair.counterpart else {
            for LineEvents { fiber, start, events } in gathered.fibers {
                let events = &mut gathered.events[events];
                sort(events);
                visit(fiber, start, events, &[]);
            }
            return Ok(());
        };
        let hits = intersections(side, bundle, &gathered, 1e-2 * layout.spacing)?;
        let [low, high] = bundle.reach();
        let mut merged: Vec<Event> = Vec::new();
        let mut next = 0;
        for (index, LineEvents { fiber, mut start, events }) in gathered.fibers.into_iter().enumerate() {
            merged.clear();
            merged.extend_from_slice(&gathered.events[events]);
            let first = next;
            while next < hits.len() && hits[next].fiber == index {
                let Intersection { hit, leaves, .. } = hits[next];
                if hit.t < low {
                    start[1] += if leaves { -1 } else { 1 };
                } else if hit.t <= high {
                    merged.push(Event { t: hit.t, source: next as u32, of_b: true, leaves });
                }
                next += 1;
            }
            if first < next {
                sort(&mut merged);
                visit(fiber, start, &merged, &hits);
            }
        }
        Ok(())
    }

    /// Measure of boundary that a crossing with this normal stands for; 0 where the fiber runs along the facet.
    pub(crate) fn weight(&self, layout: &Layout<D>, direction: &Vector<D>, normal: &Vector<D>) -> f64 {
        let slope = match (self.options.pattern, self.options.weights) {
            (FiberPattern::Isotropic { .. }, _) => direction.dot(normal).abs(),
            (FiberPattern::Lines, LineWeights::Consistent) => self.families.len() as f64 * direction.dot(normal).abs(),
            (FiberPattern::Lines, LineWeights::Balance) => {
                self.families.iter().map(|f| f.direction().dot(normal).abs()).sum::<f64>()
            }
        };
        if slope > 0.0 { layout.volume_per_length / slope } else { 0.0 }
    }
}
