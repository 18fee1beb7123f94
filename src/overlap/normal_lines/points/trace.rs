//! Contact points to look at: the lines from which the forces of a local law come.

use super::contact_points::ContactPoints;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::overlap::pair::fiber_trace::FiberTrace;
use crate::overlap::pair::sides::Pair;

/// Part of the contact's extent by which a line is drawn beyond its ends.
const MARGIN: f64 = 0.05;

impl<const D: usize> ContactPoints<D> {
    /// The line of every contact point, from boundary to boundary and a little farther.
    pub(crate) fn trace(&self, pair: &Pair<D>) -> Vec<FiberTrace<D>> {
        let ends: Vec<[Vector<D>; 2]> =
            self.points.iter().map(|point| point.ends.each_ref().map(|end| pair.position(end))).collect();
        let margin = MARGIN * Aabb::of(ends.iter().flatten()).extent().norm();
        let lines = self.points.iter().zip(&ends);
        lines
            .map(|(point, [first, last])| {
                let beyond = self.patches.directions[point.direction as usize] * margin;
                FiberTrace {
                    start: (first - beyond).into(),
                    end: (last + beyond).into(),
                    crossings: vec![(*first).into(), (*last).into()],
                }
            })
            .collect()
    }
}
