//! From the volume that a facet loses at a point to a depth there.
//!
//! As a point moves by h against the normal n of a facet, the body loses h Σ (n·n_g) ∫_g N dA, the sum over all facets g around the point that
//! go along: those beside an edge do not. The depth is that by which it loses what Archard's law says.

use super::worn::{Part, Worn, unit_normal};
use crate::Error;
use crate::geometry::{Surface, Vector, Weighting};
use std::collections::{BTreeMap, BTreeSet};

/// What a facet loses at a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WornOff {
    /// Its number in the surface.
    pub(crate) facet: usize,
    pub(crate) point: u32,
    pub(crate) volume: f64,
}

/// A facet at a point: its normal, and ∫ N dA.
type Around<const D: usize> = (Vector<D>, f64);

impl<const D: usize> Worn<D> {
    /// The same and what was worn off in a step that ends with the points of bodies here, and the next begins.
    ///
    /// # Errors
    /// [`Error::Overflow`].
    pub(crate) fn grown(
        mut self,
        surface: &Surface<D>,
        points: &[[f64; D]],
        weighting: Weighting,
        added: impl IntoIterator<Item = WornOff>,
    ) -> Result<Self, Error> {
        let mut volumes: BTreeMap<(usize, u32), f64> = BTreeMap::new();
        for WornOff { facet, point, volume } in added {
            *volumes.entry((facet, point)).or_default() += volume;
        }
        volumes.retain(|_, volume| *volume > 0.0);
        let vertices = surface.points(points);
        let around = facets_around(surface, &vertices, weighting, volumes.keys().map(|(_, point)| *point).collect());
        for ((facet, point), volume) in volumes {
            let normal = unit_normal(surface, &vertices, facet);
            let along = |(other, area): &Around<D>| area * other.dot(&normal).max(0.0);
            let depth = volume / around[&point].iter().map(along).sum::<f64>();
            if !depth.is_finite() {
                return Err(Error::Overflow { quantity: "worn depth", value: depth });
            }
            let part: &mut Part = self.parts.entry((facet, point)).or_default();
            (part.depth, part.volume) = (part.depth + depth, part.volume + volume);
        }
        Ok(self.at(surface, points))
    }
}

/// All facets that some points move.
fn facets_around<const D: usize>(
    surface: &Surface<D>,
    vertices: &[Vector<D>],
    weighting: Weighting,
    points: BTreeSet<u32>,
) -> BTreeMap<u32, Vec<Around<D>>> {
    let mut around: BTreeMap<u32, Vec<Around<D>>> = BTreeMap::new();
    for (facet, corners) in surface.facets.iter().enumerate() {
        let mut of_facet = corners.iter().flat_map(|&vertex| surface.nodes_of_vertex(vertex));
        if !of_facet.any(|(point, _)| points.contains(&point)) {
            continue;
        }
        let normal = unit_normal(surface, vertices, facet);
        surface.shares_of_facet(
            corners,
            |vertex| vertices[vertex as usize],
            weighting,
            |point, area| {
                if points.contains(&point) {
                    around.entry(point).or_default().push((normal, area));
                }
            },
        );
    }
    around
}
