//! Samples of contact by exact projection, for the search for patches.
//!
//! The facets are projected along D directions at right angles, those of the standard line families: every common piece
//! of two facets is a sample. What a facet has inside the other side is seen along all of them together, so that the
//! normals of the samples with their measures add up to the gradient of the overlap volume. Nothing is drawn at random.
//!
//! A thin overlap is all layers when it is seen from the side, one behind the other, and to look at these took nine tenths of
//! the time. So where nearly all of the boundary looks much the same way, the first direction is its mean normal, and such
//! facets are seen along this one alone.

use super::contact_points::{EDGE_ON, Rule};
use super::projected_pair::ProjectedPair;
use crate::Error;
use crate::geometry::Vector;
use crate::overlap::normal_lines::patches::sample::ContactSample;
use crate::overlap::normal_lines::points::contact_point::ContactPoint;
use crate::overlap::pair::main_normal::MainNormal;
use crate::overlap::pair::surface_point::SurfacePoint;
use crate::sampling::Family;

/// Part of all samples' measure below which one of them is left out: a hundred thousand equal ones are far above it.
const SMALLEST: f64 = 1e-9;

/// Nearly all of the boundary looks the same way if no more than this part of it looks another.
const NEARLY_ALL: f64 = 0.1;

/// Of a facet that is seen along the main normal, so large a part at least is seen from the side, or none. Flat faces whose nodes
/// are off by a millionth of a cell are as many slivers in one place, row behind row, which no line but one in a million meets.
const FLUSH: f64 = 1e-4;

/// The directions along which a contact is seen, and how much of it along each.
struct Views<const D: usize> {
    families: Vec<Family<D>>,
    /// Whose facets are seen along the first direction alone.
    main: Option<MainNormal<D>>,
}

impl<const D: usize> Views<D> {
    fn new(main: Option<MainNormal<D>>) -> Self {
        let Some(main) = main.filter(|main| main.other <= NEARLY_ALL * main.alike) else {
            // The shifts that the number is for are of no use here.
            return Self { families: Family::all(0), main: None };
        };
        let first = Family::along(main.normal, 0, 0);
        let across = [[1.0, 0.0], [0.0, 1.0]].map(|axis| first.across(axis));
        let beside = across.into_iter().take(D - 1).map(|direction| Family::along(direction, 0, 0));
        Self { families: std::iter::once(first).chain(beside).collect(), main: Some(main) }
    }

    /// Part of a facet with this area vector below which it is not seen along a family.
    fn edge_on(&self, family: usize, area: &Vector<D>) -> f64 {
        match &self.main {
            Some(main) if family > 0 && main.is_alike(area) => FLUSH,
            _ => EDGE_ON,
        }
    }

    /// For how much of the boundary with this normal a line of a family stands, in parts of what lies across the lines.
    fn part(&self, family: usize, normal: &Vector<D>) -> f64 {
        let slope = |family: &Family<D>| family.direction().dot(normal).abs();
        let slope = match &self.main {
            Some(main) if main.is_alike(normal) && family == 0 => slope(&self.families[0]),
            Some(main) if main.is_alike(normal) => return 0.0,
            _ => self.families.iter().map(slope).sum::<f64>(),
        };
        if slope > 0.0 { 1.0 / slope } else { 0.0 }
    }
}

impl<const D: usize> ProjectedPair<'_, D> {
    /// One sample for every piece between two facets, along each of the directions along which one of the two is seen.
    pub(crate) fn samples(&self) -> Result<Vec<ContactSample<D>>, Error> {
        let plane = self.pair.plane()?;
        let Some(reached) = self.reached_facets()? else { return Ok(Vec::new()) };
        let views = Views::new(self.pair.region()?.and_then(|region| self.pair.main_normal(region)));
        let mut samples = Vec::new();
        for (number, family) in views.families.iter().enumerate() {
            let is_facet_seen = |of_b: bool, facet: u32| {
                let normal = self.pair.normal_at(&SurfacePoint::Facet { of_b, facet, weights: [0.0; D] });
                views.part(number, &normal) > 0.0
            };
            let of_side = |(facets, of_b): (&Vec<u32>, bool)| facets.iter().any(|&facet| is_facet_seen(of_b, facet));
            let is_plane_seen = plane.as_ref().is_some_and(|plane| views.part(number, &plane.normal) > 0.0);
            if !is_plane_seen && !reached.facets.iter().zip([false, true]).any(of_side) {
                continue;
            }
            let sample = |point: ContactPoint<D>| {
                let ContactPoint { ends, across, length, .. } = point;
                let measures = ends.each_ref().map(|end| {
                    let weight = self.pair.weighting.at(&self.pair.position(end));
                    across * views.part(number, &self.pair.normal_at(end)) * weight
                });
                // What is shorter is none: facets that coincide but for rounding touch.
                (length > reached.rounding).then_some(ContactSample { ends, measures, length })
            };
            let edge_on = |area: &Vector<D>| views.edge_on(number, area);
            let seen = self.projection_without(family, &reached, plane.as_ref(), edge_on);
            if let Some(plane) = &plane {
                self.points_on_plane(&seen, family, plane, Rule::Middle, |point| samples.extend(sample(point)));
            }
            let wanted: Vec<bool> = seen.facets.iter().map(|seen| is_facet_seen(seen.of_b, seen.facet)).collect();
            samples.extend(self.in_order(&seen.work, seen.facets.len(), |entered, scratch, found| {
                let along = (family, plane.as_ref());
                let between = (entered, Some(&wanted[..]));
                self.points_between(&seen, along, between, Rule::Middle, scratch, |point| found.extend(sample(point)));
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
