//! The obstacles of a contact: added, moved, asked for, removed.

use super::rigid::Rigid;
use super::rigid::check_pose;
use crate::Error;
use crate::contact::interface::Contact;
use crate::geometry::{Obstacle, Pose};
use crate::overlap::Partner;

impl<const D: usize> Contact<D> {
    /// Adds a rigid partner and returns its index: 0, 1, …, also after others were removed.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::BadPose`]; for a polytope those of [`crate::Surface::from_facets`].
    pub fn add_obstacle(&mut self, obstacle: Obstacle<D>) -> Result<usize, Error> {
        let index = self.obstacles.len();
        self.obstacles.push(Some(Rigid::new(obstacle, index)?));
        Ok(index)
    }

    /// Removes an obstacle and the options of its pairs. The others keep their indices; its own is never given again, and
    /// stands in results with a resultant of zero.
    ///
    /// # Errors
    /// [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`].
    pub fn remove_obstacle(&mut self, obstacle: usize) -> Result<(), Error> {
        self.rigid(obstacle)?;
        self.obstacles[obstacle] = None;
        let partner = Partner::Obstacle(obstacle);
        self.pair_table.forget(partner);
        self.kept.retain(|(pair, _)| !pair.contains(&partner));
        self.multipliers.forget(partner);
        self.forget_found();
        Ok(())
    }

    /// Shape and pose of an obstacle.
    ///
    /// # Errors
    /// [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`].
    pub fn obstacle(&self, obstacle: usize) -> Result<&Obstacle<D>, Error> {
        Ok(&self.rigid(obstacle)?.obstacle)
    }

    /// Moves an obstacle.
    ///
    /// # Errors
    /// [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`], [`Error::BadPose`].
    pub fn set_pose(&mut self, obstacle: usize, pose: Pose<D>) -> Result<(), Error> {
        check_pose(&pose, obstacle)?;
        self.rigid(obstacle)?;
        if let Some(rigid) = &mut self.obstacles[obstacle] {
            let is_scaled = rigid.obstacle.pose.scale != pose.scale;
            rigid.obstacle.pose = pose;
            if is_scaled {
                self.pair_table.rescale(obstacle, rigid);
            }
        }
        self.forget_found();
        Ok(())
    }

    /// Number of obstacles, with those that were removed: the next one gets this index.
    pub fn obstacle_count(&self) -> usize {
        self.obstacles.len()
    }

    /// The obstacle, if it is there.
    pub(crate) fn rigid(&self, obstacle: usize) -> Result<&Rigid<D>, Error> {
        let count = self.obstacles.len();
        let place = self.obstacles.get(obstacle).ok_or(Error::ObstacleOutOfRange { obstacle, count })?;
        place.as_ref().ok_or(Error::ObstacleRemoved { obstacle })
    }
}
