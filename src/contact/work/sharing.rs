//! Evaluations that several ranks share.

use crate::Error;
use crate::contact::interface::Contact;
use crate::contact::method::Options;
use crate::ranks::{Communicator, RankCounts, Ranks};
use std::hash::Hasher;

impl<const D: usize> Contact<D> {
    /// Shares the work of evaluations with other ranks, `None`: no more. From then on every rank makes the same calls with the
    /// same coordinates, options, obstacles and history, and gets the whole result, with the bits of one rank alone. Threads
    /// may differ. Pairs with a signed distance function are measured on every rank.
    ///
    /// Where an evaluation fails on one rank it fails on all. Where ranks were given different things, all are told.
    ///
    /// # Errors
    /// [`Error::BadRank`]; what was set before then stays.
    pub fn set_communicator(&mut self, communicator: Option<Box<dyn Communicator>>) -> Result<(), Error> {
        self.surface.refuse_submesh("another communicator for a mesh that is given in parts")?;
        self.ranks = communicator.map(Ranks::new).transpose()?;
        Ok(())
    }

    /// The same of ranks that have met before.
    pub(crate) fn take_ranks(&mut self, ranks: Ranks) {
        self.ranks = Some(ranks);
    }

    /// Those that share the work.
    pub(crate) fn ranks(&self) -> Option<&Ranks> {
        self.ranks.as_ref()
    }

    /// What was shared since the communicator was set; zeros without one.
    pub fn rank_counts(&self) -> RankCounts {
        self.ranks.as_ref().map(Ranks::counts).unwrap_or_default()
    }

    /// Hash of what ranks must have in common, and of what is asked for.
    pub(crate) fn given(&self, coords: &[[f64; D]], asked: &str) -> u64 {
        let mut hasher = rustc_hash::FxHasher::default();
        let mut add = |x: f64| hasher.write_u64(x.to_bits());
        coords.as_flattened().iter().for_each(|x| add(*x));
        for rigid in self.obstacles.iter().flatten() {
            let pose = &rigid.obstacle.pose;
            pose.position.iter().chain(pose.rotation.as_flattened()).for_each(|x| add(*x));
            add(pose.scale);
        }
        let options = Options { threads: 1, ..self.options };
        hasher.write(format!("{options:?}").as_bytes());
        hasher.write(asked.as_bytes());
        hasher.write_usize(self.surface.facet_count());
        hasher.finish()
    }
}
