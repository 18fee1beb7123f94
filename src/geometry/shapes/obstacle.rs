//! Rigid partners: a shape with a pose.

use super::{Shape, Solid};
use crate::Error;
use crate::geometry::Pose;

/// A rigid partner: it meets every body of the mesh, but no other obstacle.
#[derive(Clone, Debug)]
pub struct Obstacle<const D: usize> {
    /// Shape in its own frame.
    pub shape: Shape<D>,
    /// Where it stands.
    pub pose: Pose<D>,
}

impl<const D: usize> Obstacle<D> {
    /// Checks pose and shape, and returns what contact is measured with. `obstacle` is the number that errors name.
    pub(crate) fn solid(&self, obstacle: usize) -> Result<Solid<D>, Error> {
        self.pose.check(obstacle)?;
        self.shape.solid(obstacle)
    }
}
