//! Rigid partners.

use crate::Error;
use crate::contact::changes;
use crate::contact::evaluation::Contact;
use crate::geometry::{Obstacle, Pose};

impl<const D: usize> Contact<D> {
    /// Adds a rigid partner and returns its index: 0, 1, …, also after others were removed.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::BadPose`]; for a polytope those of [`crate::Surface::from_facets`].
    #[inline(never)]
    pub fn add_obstacle(&mut self, obstacle: Obstacle<D>) -> Result<usize, Error> {
        self.partners.obstacles.add(obstacle)
    }

    /// Moves an obstacle. The whole pose is set, its rotation and scale too.
    ///
    /// # Errors
    /// [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`], [`Error::BadPose`].
    #[inline(never)]
    pub fn set_pose(&mut self, obstacle: usize, pose: Pose<D>) -> Result<(), Error> {
        changes::options::set_pose(self, obstacle, pose)
    }

    /// Shape and pose of an obstacle.
    ///
    /// # Errors
    /// [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`].
    pub fn obstacle(&self, obstacle: usize) -> Result<&Obstacle<D>, Error> {
        Ok(&self.partners.obstacles.rigid(obstacle)?.obstacle)
    }

    /// Number of obstacles, with those that were removed: the next one gets this index.
    pub fn obstacle_count(&self) -> usize {
        self.partners.obstacles.count()
    }

    /// Removes an obstacle and the options of its pairs. The others keep their indices; its own is never given again, and
    /// stands in results with a resultant of zero.
    ///
    /// # Errors
    /// [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`].
    #[inline(never)]
    pub fn remove_obstacle(&mut self, obstacle: usize) -> Result<(), Error> {
        changes::options::remove_obstacle(self, obstacle)
    }

    /// Whether tangents have the rotations of the obstacles, too; they have not at first. Number `node_count +
    /// obstacle_count + o` is then the rotation of obstacle o, a rotation vector about the position of its pose, which moves
    /// along; in 2D its first entry is the angle, and the second has none but zeros. Not with axisymmetry, where nothing turns;
    /// for an obstacle that a body meets by the law `fiber`, the tangent is then refused.
    ///
    /// It is the second derivative of the energy, and symmetric, with what the tangent of friction has. The derivative of the moment about the position,
    /// M, as the obstacle turns by dθ is −(∂²w/∂θ²) dθ + ½ dθ × M.
    pub fn set_obstacle_rotations(&mut self, on: bool) {
        self.method.obstacle_rotations = on;
    }

    /// Whether they have.
    pub fn obstacle_rotations(&self) -> bool {
        self.method.obstacle_rotations
    }
}
