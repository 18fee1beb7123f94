//! Samples of contact on a first, coarser set of lines, for the search for patches.

use crate::Error;
use crate::overlap::lines::layout::{FiberPair, Layout};
use crate::overlap::normal_lines::patches::sample::ContactSample;
use crate::overlap::pair::surface_point::SurfacePoint;

/// Lines of the first pass are this much further apart: it needs no more than the mean normal.
const COARSER: f64 = 2.0;

impl<const D: usize> FiberPair<'_, D> {
    /// Every span on the lines of the standard families, laid coarsely.
    pub(crate) fn samples(&self) -> Result<Vec<ContactSample<D>>, Error> {
        let samples = self.with_layout(COARSER, |layout| {
            let samples = self.for_each_bundle(layout, |bundle| {
                let mut samples = Vec::new();
                self.visit_spans(bundle, layout, 0, |sampled| {
                    let (ends, length) = (sampled.point.ends, sampled.point.length);
                    let measures = ends.each_ref().map(|end| self.measure_at(layout, length, end));
                    samples.push(ContactSample { ends, measures, length });
                })?;
                Ok(samples)
            })?;
            Ok(samples.into_iter().flatten().collect())
        })?;
        Ok(samples.unwrap_or_default())
    }

    /// Measure of boundary at an end of a span.
    fn measure_at(&self, layout: &Layout<D>, length: f64, end: &SurfacePoint<D>) -> f64 {
        let normal = self.pair.normal_at(end);
        let slope: f64 = self.families.iter().map(|f| f.direction().dot(&normal).abs()).sum();
        // Long spans cross a body from side to side; those of the contact are short.
        let weight = self.pair.weighting.at(&self.pair.position(end));
        if slope > 0.0 && length > 0.0 { layout.volume_per_length / slope * weight } else { 0.0 }
    }
}
