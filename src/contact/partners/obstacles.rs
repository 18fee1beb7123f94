//! The obstacles of a contact: added, moved, asked for, removed.

use super::rigid::Rigid;
use crate::Error;
use crate::geometry::{Obstacle, Pose};

/// Where obstacles are, by index; `None` for one that was removed.
pub(crate) type Poses<const D: usize> = Vec<Option<Pose<D>>>;

/// By index; `None` where one was removed.
pub(crate) struct Obstacles<const D: usize>(Vec<Option<Rigid<D>>>);

impl<const D: usize> Obstacles<D> {
    pub(crate) fn new() -> Self {
        Self(Vec::new())
    }

    /// Adds one and returns its index.
    pub(crate) fn add(&mut self, obstacle: Obstacle<D>) -> Result<usize, Error> {
        let index = self.0.len();
        self.0.push(Some(Rigid::new(obstacle, index)?));
        Ok(index)
    }

    pub(crate) fn remove(&mut self, obstacle: usize) -> Result<(), Error> {
        self.rigid(obstacle)?;
        self.0[obstacle] = None;
        Ok(())
    }

    /// Moves one; returns it if it has another scale than before.
    pub(crate) fn set_pose(&mut self, obstacle: usize, pose: Pose<D>) -> Result<Option<&Rigid<D>>, Error> {
        pose.check(obstacle)?;
        self.rigid(obstacle)?;
        let Some(rigid) = &mut self.0[obstacle] else { return Ok(None) };
        let is_scaled = rigid.obstacle.pose.scale != pose.scale;
        rigid.obstacle.pose = pose;
        Ok(is_scaled.then_some(rigid))
    }

    /// Number of obstacles, with those that were removed.
    pub(crate) fn count(&self) -> usize {
        self.0.len()
    }

    /// The obstacle, if it is there.
    pub(crate) fn rigid(&self, obstacle: usize) -> Result<&Rigid<D>, Error> {
        let count = self.0.len();
        let place = self.0.get(obstacle).ok_or(Error::ObstacleOutOfRange { obstacle, count })?;
        place.as_ref().ok_or(Error::ObstacleRemoved { obstacle })
    }

    /// The same of an index that is in range.
    pub(crate) fn get(&self, obstacle: usize) -> Option<&Rigid<D>> {
        self.0[obstacle].as_ref()
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = Option<&Rigid<D>>> {
        self.0.iter().map(Option::as_ref)
    }

    /// Where they are.
    pub(crate) fn poses(&self) -> Poses<D> {
        self.iter().map(|rigid| rigid.map(|rigid| rigid.obstacle.pose)).collect()
    }

    /// Puts them where `poses` says, and into `poses` where they were.
    pub(crate) fn exchange_poses(&mut self, poses: &mut Poses<D>) {
        for (rigid, pose) in self.0.iter_mut().zip(poses) {
            if let (Some(rigid), Some(pose)) = (rigid, pose) {
                std::mem::swap(&mut rigid.obstacle.pose, pose);
            }
        }
    }
}
