//! Crossings of a bundle's fibers with an obstacle that has no facets.

use super::bundle::Bundle;
use super::gather::Gathered;
use super::side::ImplicitSide;
use crate::Error;
use crate::geometry::{Passage, Shape, Stretch, chord, march};

/// Passages of every gathered fiber through the obstacle, between its first and its last event; ordered by fiber.
pub(crate) fn passages<const D: usize>(
    side: &ImplicitSide<D>,
    bundle: &Bundle<D>,
    gathered: &Gathered,
    resolution: f64,
) -> Result<Vec<Passage<D>>, Error> {
    if let Shape::SignedDistance(function) = side.shape {
        let stretches: Vec<Stretch<D>> = gathered
            .fibers
            .iter()
            .map(|gathering| {
                let (origin, direction) = bundle.ray(gathering.fiber);
                let [start, end] = bundle.stretch(gathering, &gathered.events);
                Stretch { origin, direction, start, end }
            })
            .collect();
        return march(function.as_ref(), side.pose, &stretches, resolution)
            .map_err(|point| Error::SignedDistance { obstacle: side.obstacle, point });
    }
    let mut passages = Vec::with_capacity(2 * gathered.fibers.len());
    for (stretch, gathering) in gathered.fibers.iter().enumerate() {
        let (origin, direction) = bundle.ray(gathering.fiber);
        let found = chord(side.shape, &side.pose.unplace(&origin), &side.pose.unrotate(&direction));
        for (mut hit, leaves) in found.into_iter().flatten().zip([false, true]) {
            hit.t *= side.pose.scale;
            hit.normal = side.pose.rotate(&hit.normal);
            passages.push(Passage { stretch, hit, leaves });
        }
    }
    Ok(passages)
}
