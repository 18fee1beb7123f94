//! Samples of contact by exact projection, for the search for patches.
//!
//! The facets are projected along D directions at right angles, those of the standard line families: every common piece
//! of two facets is a sample. What a facet has inside the other side is seen along all of them together, so that the
//! normals of the samples with their measures add up to the gradient of the overlap volume. Nothing is drawn at random.

use super::contact_points::Rule;
use crate::Error;
use crate::geometry::Vector;
use crate::overlap::exact::clipping::volume::ExactPair;
use crate::overlap::patches::sample::ContactSample;
use crate::overlap::points::contact_point::ContactPoint;
use crate::sampling::Family;

/// Part of all samples' measure below which one of them is left out: a hundred thousand equal ones are far above it.
const SMALLEST: f64 = 1e-9;

impl<const D: usize> ExactPair<'_, D> {
    /// One sample for every piece between two facets, along any of the directions.
    pub(crate) fn samples(&self) -> Result<Vec<ContactSample<D>>, Error> {
        let plane = self.plane()?;
        let Some(reached) = self.reached_facets()? else { return Ok(Vec::new()) };
        // The shifts that the number is for are of no use here.
        let families = Family::<D>::all(0);
        let along_all = |normal: Vector<D>| families.iter().map(|f| f.direction().dot(&normal).abs()).sum::<f64>();
        let sample = |point: ContactPoint<D>| {
            let ContactPoint { ends, across, length, .. } = point;
            let measures = ends.each_ref().map(|end| {
                let slope = along_all(self.pair.normal_at(end));
                let weight = self.pair.weighting.at(&self.pair.position(end));
                if slope > 0.0 { across / slope * weight } else { 0.0 }
            });
            // What is shorter is none: facets that coincide but for rounding touch.
            (length > reached.rounding).then_some(ContactSample { ends, measures, length })
        };
        let mut samples = Vec::new();
        for family in &families {
            let seen = self.projection(family, &reached, plane.as_ref());
            if let Some(plane) = &plane {
                self.points_on_plane(&seen, family, plane, Rule::Middle, |point| samples.extend(sample(point)));
            }
            samples.extend(self.in_order(&seen.work, seen.facets.len(), |entered, scratch, found| {
                let along = (family, plane.as_ref());
                self.points_between(&seen, along, entered, Rule::Middle, scratch, |point| found.extend(sample(point)));
            }));
            self.check(&seen.work)?;
        }
        // A piece this small is seen or not by chance of rounding, and must not join what does not touch.
        let measure = |sample: &ContactSample<D>| sample.measures[0] + sample.measures[1];
        let least = SMALLEST * samples.iter().map(measure).sum::<f64>();
        samples.retain(|sample| measure(sample) > least);
        Ok(samples)
    }
}
