//! Crossings of a bundle's fibers with an obstacle that has no facets.

use super::bundle::Bundle;
use super::crossings::BundleEvents;
use crate::Error;
use crate::geometry::shapes::ImplicitShape;
use crate::geometry::{Intersection, MARCH_ROUNDS, MarchFailure, SearchInterval, march};
use crate::overlap::pair::sides::ImplicitSide;

/// Passages of every gathered fiber through the obstacle, between its first and its last event; ordered by fiber.
pub(crate) fn intersections<const D: usize>(
    side: &ImplicitSide<D>,
    bundle: &Bundle<D>,
    gathered: &BundleEvents,
    resolution: f64,
) -> Result<Vec<Intersection<D>>, Error> {
    let shape = match side.shape {
        ImplicitShape::Convex(shape) => shape,
        ImplicitShape::Function(function) => {
            let intervals: Vec<SearchInterval<D>> = gathered
                .fibers
                .iter()
                .map(|gathering| {
                    let (origin, direction) = bundle.ray(gathering.fiber);
                    let [start, end] = bundle.interval(gathering, &gathered.events);
                    SearchInterval { origin, direction, start, end }
                })
                .collect();
            let obstacle = side.obstacle;
            return march(function.as_ref(), side.pose, &intervals, resolution).map_err(|failure| match failure {
                MarchFailure::AtPoint(point) => Error::SignedDistance { obstacle, point },
                MarchFailure::Unfinished(lines) => Error::UnfinishedLines { obstacle, lines, steps: MARCH_ROUNDS },
            });
        }
    };
    let mut intersections = Vec::with_capacity(2 * gathered.fibers.len());
    for (fiber, gathering) in gathered.fibers.iter().enumerate() {
        let (origin, direction) = bundle.ray(gathering.fiber);
        let found = shape.chord(&side.pose.unplace(&origin), &side.pose.unrotate(&direction));
        for (mut hit, leaves) in found.into_iter().flatten().zip([false, true]) {
            hit.t *= side.pose.scale;
            hit.normal = side.pose.rotate(&hit.normal);
            intersections.push(Intersection { fiber, hit, leaves });
        }
    }
    Ok(intersections)
}
