//! Friction with the points and the pressure of an earlier iteration: the forces are then those of a convex potential.

use super::slip_points::SlipPoints;
use crate::geometry::{Pose, Vector};
use crate::overlap::Partner;

/// The points of all pairs, and where all stood when they were taken.
#[derive(Clone)]
pub(crate) struct FrozenPoints<const D: usize> {
    pub(crate) pairs: Vec<SlipPoints<D>>,
    pub(crate) coords: Vec<[f64; D]>,
    pub(crate) poses: Vec<Option<Pose<D>>>,
}

impl<const D: usize> FrozenPoints<D> {
    /// The points with the slip that displacements since then have added; nothing else of them changes.
    pub(crate) fn at(&self, coords: &[[f64; D]], poses: &[Option<Pose<D>>]) -> Vec<SlipPoints<D>> {
        let mut pairs = self.pairs.clone();
        for SlipPoints { partners, points, rows } in &mut pairs {
            for point in points {
                let mut slip = Vector::zeros();
                for row in &rows[point.rows.clone()] {
                    let node = row.node as usize;
                    let moved = match (coords.get(node), partners[1]) {
                        (Some(x), _) => Vector::from(*x) - Vector::from(self.coords[node]),
                        (None, Partner::Obstacle(o)) => self.moved_with(o, &poses[o], &point.position),
                        _ => Vector::zeros(),
                    };
                    slip += row.slip * moved;
                }
                point.trial += slip - point.normal * point.normal.dot(&slip);
            }
        }
        pairs
    }

    /// How far a point of an obstacle has moved.
    fn moved_with(&self, obstacle: usize, pose: &Option<Pose<D>>, x: &Vector<D>) -> Vector<D> {
        match (&self.poses.get(obstacle).copied().flatten(), pose) {
            (Some(old), Some(new)) => new.place(&old.unplace(x)) - x,
            _ => Vector::zeros(),
        }
    }
}
