//! Threads and ranks that share the work of evaluations.

use super::workers::Workers;
use crate::Error;
use crate::ranks::{Asked, Communicator, Interrupt, RankCounts, Ranks, Sharing};

/// Those that share the work of one contact. No result depends on them.
pub(crate) struct Work {
    workers: Option<Workers>,
    ranks: Option<Ranks>,
    interrupt: Option<Interrupt>,
}

impl Work {
    /// Threads alone.
    pub(crate) fn new(threads: usize) -> Result<Self, Error> {
        Ok(Self { workers: Workers::new(threads)?, ranks: None, interrupt: None })
    }

    /// Another number of threads; the old ones stay on an error.
    pub(crate) fn set_threads(&mut self, threads: usize) -> Result<(), Error> {
        self.workers = Workers::new(threads)?;
        Ok(())
    }

    pub(crate) fn set_communicator(&mut self, communicator: Option<Box<dyn Communicator>>) -> Result<(), Error> {
        self.ranks = communicator.map(Ranks::new).transpose()?;
        Ok(())
    }

    /// The same of ranks that have met before.
    pub(crate) fn take_ranks(&mut self, ranks: Ranks) {
        self.ranks = Some(ranks);
    }

    /// Takes what to ask whether a call is to end, `None`: nobody.
    pub(crate) fn set_interrupt(&mut self, asked: Option<Asked>) {
        self.interrupt = asked.map(Interrupt::new);
    }

    /// Who may end a call; nobody where ranks work together, which would wait for one another.
    pub(crate) fn interrupt(&self) -> Option<&Interrupt> {
        self.interrupt.as_ref().filter(|_| self.ranks.is_none())
    }

    /// The ranks that share the work.
    pub(crate) fn ranks(&self) -> Option<&Ranks> {
        self.ranks.as_ref()
    }

    /// What was shared since the communicator was set; zeros without one.
    pub(crate) fn rank_counts(&self) -> RankCounts {
        self.ranks.as_ref().map(Ranks::counts).unwrap_or_default()
    }

    /// The threads that share the work, if there are some.
    pub(crate) fn pool(&self) -> Option<&rayon::ThreadPool> {
        self.workers.as_ref().and_then(Workers::pool)
    }

    /// How the work within a pair is shared.
    pub(crate) fn within_pair(&self, is_marched: bool) -> Sharing<'_> {
        match &self.ranks {
            // A function of the host is called on the thread that evaluates, on every rank at all points.
            _ if is_marched => Sharing::Alone(self.interrupt()),
            Some(ranks) => Sharing::Ranks { ranks, pool: self.pool() },
            // Outside the pool there is none to share the work with.
            None if self.pool().is_some() => Sharing::Threads(self.interrupt()),
            None => Sharing::Alone(self.interrupt()),
        }
    }
}
