//! Fibers to look at.

use super::layout::FiberPair;
use super::sweep::sweep;
use crate::Error;
use crate::overlap::pair::fiber_trace::FiberTrace;

impl<const D: usize> FiberPair<'_, D> {
    /// The fibers that cross the overlap.
    pub(crate) fn trace(&self) -> Result<Vec<FiberTrace<D>>, Error> {
        let traced = self.with_layout(1.0, |layout| {
            let traces = self.for_each_bundle(layout, |bundle| {
                let mut traces = Vec::new();
                let margin = 0.05 * layout.region.extent().norm();
                self.visit_fibers(bundle, layout, |fiber, start, events, _| {
                    let (origin, direction) = bundle.ray(fiber);
                    let at = |t: f64| -> [f64; D] { (origin + direction * t).into() };
                    let mut ts = Vec::new();
                    let length =
                        sweep(start, events, self.pair.is_own(), bundle.length(), layout.tolerance, |event, _| {
                            ts.push(event.t)
                        });
                    if length > 0.0 {
                        let (start, end) = match (bundle.length(), ts.first(), ts.last()) {
                            (Some(length), _, _) => (0.0, length),
                            (None, Some(first), Some(last)) => (first - margin, last + margin),
                            _ => return,
                        };
                        traces.push(FiberTrace {
                            start: at(start),
                            end: at(end),
                            crossings: ts.iter().map(|&t| at(t)).collect(),
                        });
                    }
                })?;
                Ok(traces)
            })?;
            Ok(traces.into_iter().flatten().collect())
        })?;
        Ok(traced.unwrap_or_default())
    }
}
