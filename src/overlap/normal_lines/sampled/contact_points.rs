//! Contact points on sampled lines, one family along the direction of every patch.

use crate::Error;
use crate::geometry::primitives::crossing::weights_at;
use crate::overlap::lines::bundle::Bundle;
use crate::overlap::lines::layout::{FiberPair, Layout};
use crate::overlap::lines::resolution::FEWEST_FIBERS;
use crate::overlap::lines::sweep::{Event, for_each_span};
use crate::overlap::normal_lines::patches::partition::Patches;
use crate::overlap::normal_lines::points::contact_point::ContactPoint;
use crate::overlap::normal_lines::points::contact_points::ContactPoints;
use crate::overlap::pair::options::{FiberOptions, LineWeights, Resolution};
use crate::overlap::pair::sides::Counterpart;
use crate::overlap::pair::surface_point::SurfacePoint;
use crate::overlap::pair::warning::Warning;
use crate::sampling::Family;

impl<const D: usize> FiberPair<'_, D> {
    /// All spans along the directions of `patches`, or `None` where the sides are apart.
    pub(crate) fn contact_points(&self, patches: &Patches<D>) -> Result<Option<ContactPoints<D>>, Error> {
        patches.check(self.pair.weighting)?;
        let mut points: Option<ContactPoints<D>> = None;
        for direction in 0..patches.directions.len() {
            let Some(found) = self.points_along(patches, direction)? else { continue };
            let all = points.get_or_insert_with(ContactPoints::default);
            all.points.extend(found.points);
            all.standard_error = all.standard_error.hypot(found.standard_error);
            all.fiber_count += found.fiber_count;
            all.spacing = if all.spacing > 0.0 { all.spacing.min(found.spacing) } else { found.spacing };
            all.warnings.extend(found.warnings);
        }
        if let Some(all) = &mut points {
            all.patches.clone_from(patches);
        }
        Ok(points)
    }

    fn points_along(&self, patches: &Patches<D>, direction: usize) -> Result<Option<ContactPoints<D>>, Error> {
        let family = Family::along(patches.directions[direction], self.options.seed, direction as u64);
        let resolution = patches.spacing.map_or(self.options.resolution, Resolution::Spacing);
        let pair = FiberPair {
            pair: self.pair,
            families: std::slice::from_ref(&family),
            // One family has nothing to combine.
            options: &FiberOptions { resolution, weights: LineWeights::Balance, ..*self.options },
        };
        pair.with_layout(1.0, |layout| {
            let found = pair.for_each_bundle(layout, |bundle| {
                let mut spans = Vec::new();
                let mut volume_by_parity = [0.0; 2];
                pair.visit_spans(bundle, layout, direction as u32, |Sampled { mut point, parity }| {
                    point.weight *= patches.part(direction, &point.ends).value * self.pair.weight_between(&point.ends);
                    if point.weight > 0.0 {
                        volume_by_parity[parity] += point.weight * point.length;
                        spans.push(point);
                    }
                })?;
                Ok((spans, volume_by_parity))
            })?;
            Ok(pair.collect(layout, found))
        })
    }

    fn collect(&self, layout: &Layout<D>, found: Vec<(Vec<ContactPoint<D>>, [f64; 2])>) -> ContactPoints<D> {
        let mut all = ContactPoints { spacing: layout.spacing, ..ContactPoints::default() };
        all.fiber_count = layout.bundles.iter().map(Bundle::fiber_count).sum();
        let mut halves = [0.0; 2];
        for (spans, [even, odd]) in found {
            all.points.extend(spans);
            (halves[0], halves[1]) = (halves[0] + even, halves[1] + odd);
        }
        // Every other line would do alone; the two estimates differ by twice the error of their mean.
        all.standard_error = (halves[0] - halves[1]).abs();
        let [a, b] = self.pair.partners;
        let Layout { spacing, facet_size, .. } = *layout;
        if spacing > facet_size && !all.points.is_empty() {
            all.warnings.push(Warning::CoarseFibers { a, b, spacing, facet_size });
        }
        if (1..FEWEST_FIBERS).contains(&all.points.len()) {
            all.warnings.push(Warning::UnresolvedOverlap { a, b, fibers: all.points.len() });
        }
        all
    }

    /// Calls `visit` for every span on the lines of a bundle.
    pub(crate) fn visit_spans(
        &self,
        bundle: &Bundle<D>,
        layout: &Layout<D>,
        direction: u32,
        mut visit: impl FnMut(Sampled<D>),
    ) -> Result<(), Error> {
        self.visit_fibers(bundle, layout, |fiber, start, events, hits| {
            let (origin, along) = bundle.ray(fiber);
            let (i, j) = bundle.grid_point(fiber);
            let end = |event: &Event| match (&self.pair.counterpart, event.of_b) {
                (Counterpart::Implicit(_), true) => {
                    let hit = &hits[event.source as usize].hit;
                    SurfacePoint::Point { point: origin + along * hit.t, normal: hit.normal }
                }
                (_, of_b) => {
                    let p = bundle.project(self.pair.side(of_b), event.source as usize, fiber);
                    let (weights, _) = weights_at::<D>(std::array::from_fn(|k| &p[k]), i as f64, j as f64);
                    SurfacePoint::Facet { of_b, facet: event.source, weights }
                }
            };
            for_each_span(start, events, self.pair.is_own(), layout.tolerance, |entering, leaving| {
                for (first, part) in entering {
                    for (last, rest) in leaving {
                        let weight = layout.volume_per_length * part * rest;
                        let ends = [end(first), end(last)];
                        let length = (last.t - first.t).max(0.0);
                        let point = ContactPoint { weight, across: weight, length, direction, ends };
                        visit(Sampled { point, parity: (i + j).rem_euclid(2) as usize });
                    }
                }
            });
        })
    }
}

/// A span and on which half of the lines it lies.
pub(crate) struct Sampled<const D: usize> {
    pub(crate) point: ContactPoint<D>,
    pub(crate) parity: usize,
}
