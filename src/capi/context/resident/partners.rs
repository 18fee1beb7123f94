//! Obstacles, options of all pairs and of one, and ranks that share the work.

use super::Resident;
use crate::capi::boundary::failure::Failure;
use crate::capi::structs::pose::fmc_pose;
use crate::capi::structs::shape::fmc_shape;
use crate::contact::PairOptions;
use crate::overlap::Partner;
use crate::{Communicator, Obstacle, Options, Pose, RankCounts, ShapeKind};

impl<const D: usize> Resident<D> {
    pub(crate) fn set_options(&mut self, options: Options) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_options(options)?)
    }

    /// That of the law, as options and [`Self::stiffen`] have left it.
    pub(crate) fn stiffness(&self) -> f64 {
        self.held.contact().options().law.stiffness()
    }

    pub(crate) fn set_pose(&mut self, obstacle: usize, pose: fmc_pose) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_pose(obstacle, pose.to_pose())?)
    }

    pub(crate) fn remove_obstacle(&mut self, obstacle: usize) -> Result<(), Failure> {
        Ok(self.held.contact_mut().remove_obstacle(obstacle)?)
    }

    /// Shape and pose of an obstacle.
    pub(crate) fn obstacle(&self, obstacle: usize) -> Result<(ShapeKind, fmc_pose), Failure> {
        let found = self.held.contact().obstacle(obstacle)?;
        Ok((found.shape.kind(), (&found.pose).into()))
    }

    /// Sets the options of a pair, which goes on to wear as it did; `None`: those of the contact.
    pub(crate) fn set_pair_options(
        &mut self,
        partners: [Partner; 2],
        options: Option<PairOptions>,
    ) -> Result<(), Failure> {
        let wear_coefficients = self.pair_options(partners)?.wear_coefficients;
        let options = options.map(|options| PairOptions { wear_coefficients, ..options });
        Ok(self.held.contact_mut().set_pair_options(partners, options)?)
    }

    /// Sets what a pair wears by, and nothing else.
    pub(crate) fn set_pair_wear(&mut self, partners: [Partner; 2], coefficients: [f64; 2]) -> Result<(), Failure> {
        let options = PairOptions { wear_coefficients: coefficients, ..self.pair_options(partners)? };
        let is_its_own = self.held.contact().pair_options(partners)?.is_some();
        // A pair without options of its own follows those of the contact, also after they change.
        let options = (is_its_own || coefficients != [0.0; 2]).then_some(options);
        Ok(self.held.contact_mut().set_pair_options(partners, options)?)
    }

    /// Options that hold for a pair.
    pub(crate) fn pair_options(&self, partners: [Partner; 2]) -> Result<PairOptions, Failure> {
        let is_left_out = partners[0] == partners[1] && !self.held.contact().options().self_contact;
        let by_default = PairOptions { excluded: is_left_out, ..PairOptions::default() };
        Ok(self.held.contact().pair_options(partners)?.unwrap_or(by_default))
    }

    /// Adds an obstacle and returns its index.
    pub(crate) unsafe fn add_obstacle(
        &mut self,
        shape: &fmc_shape,
        pose: fmc_pose,
        index_base: i32,
    ) -> Result<usize, Failure> {
        // SAFETY: passed on to the caller.
        let shape = unsafe { shape.read_shape(index_base) }?;
        let pose: Pose<D> = pose.to_pose();
        self.held.contact_mut().add_obstacle(Obstacle { shape, pose }).map_err(Failure::counted_from(index_base))
    }

    /// Shares the work with other ranks, or with none.
    pub(crate) fn set_communicator(&mut self, communicator: Option<Box<dyn Communicator>>) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_communicator(communicator)?)
    }

    /// What was shared.
    pub(crate) fn rank_counts(&self) -> RankCounts {
        self.held.contact().rank_counts()
    }

    /// Whether tangents have the rotations of the obstacles.
    pub(crate) fn set_obstacle_rotations(&mut self, on: bool) {
        self.held.contact_mut().set_obstacle_rotations(on);
    }
}
