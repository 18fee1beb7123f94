//! By whom a piece of work is done.

use super::interrupt::Interrupt;
use super::packed::Packed;
use super::shared_work::Ranks;
use rayon::prelude::*;

/// By whom.
#[derive(Clone, Copy)]
pub(crate) enum Sharing<'a> {
    /// By the thread that calls.
    Alone(Option<&'a Interrupt>),
    /// By the threads of the pool that calls.
    Threads(Option<&'a Interrupt>),
    /// By all ranks, and on each by the threads of a pool if there is one. Called on the thread that evaluates.
    Ranks { ranks: &'a Ranks, pool: Option<&'a rayon::ThreadPool> },
}

impl Sharing<'_> {
    /// Ends the work if its caller wishes; ranks, which wait for one another, go on.
    pub(crate) fn check(&self) {
        if let Sharing::Alone(Some(interrupt)) | Sharing::Threads(Some(interrupt)) = self {
            interrupt.check();
        }
    }

    /// Two pieces of work, on two threads if there are some; ranks do both.
    pub(crate) fn both<T: Send, U: Send>(
        &self,
        first: impl FnOnce() -> T + Send,
        second: impl FnOnce() -> U + Send,
    ) -> (T, U) {
        match self {
            Sharing::Threads(_) => rayon::join(first, second),
            // What is in them may be shared among ranks, one after the other.
            Sharing::Alone(_) | Sharing::Ranks { .. } => (first(), second()),
        }
    }

    /// What `work` makes of every chunk of some items, in their order, shared among threads; every rank does all.
    pub(crate) fn on_threads<T: Sync, U: Send>(
        &self,
        items: &[T],
        size: usize,
        work: impl Fn(&[T]) -> U + Send + Sync,
    ) -> Vec<U> {
        let work = |chunk: &[T]| {
            self.check();
            work(chunk)
        };
        match self {
            Sharing::Alone(_) => items.chunks(size).map(work).collect(),
            Sharing::Threads(_) => items.par_chunks(size).map(work).collect(),
            Sharing::Ranks { pool, .. } => {
                let chunks: Vec<&[T]> = items.chunks(size).collect();
                on_pool(*pool, &chunks, |chunk| work(chunk))
            }
        }
    }

    /// The same, shared among ranks too.
    pub(crate) fn in_chunks<T: Sync, U: Packed + Send>(
        &self,
        items: &[T],
        size: usize,
        work: impl Fn(&[T]) -> U + Send + Sync,
    ) -> Vec<U> {
        let Sharing::Ranks { ranks, pool } = self else { return self.on_threads(items, size, work) };
        let chunks: Vec<&[T]> = items.chunks(size).collect();
        ranks.share(chunks.len(), items.len(), |numbers| on_pool(*pool, numbers, |number| work(chunks[*number])))
    }

    /// Whether ranks share so many chunks of work.
    pub(crate) fn is_shared(&self, chunk_count: usize) -> bool {
        matches!(self, Sharing::Ranks { ranks, .. } if ranks.are_enough(chunk_count))
    }

    /// The sum of a number that every rank counted in its part of the work.
    pub(crate) fn total(&self, count: usize) -> usize {
        match self {
            Sharing::Ranks { ranks, .. } => ranks.total(count),
            _ => count,
        }
    }

    /// Sorts keys that all differ.
    pub(crate) fn sort<T: Ord + Send>(&self, keys: &mut [T]) {
        match self {
            Sharing::Threads(_) => keys.par_sort_unstable(),
            _ => keys.sort_unstable(),
        }
    }
}

fn on_pool<T: Sync, U: Send>(
    pool: Option<&rayon::ThreadPool>,
    items: &[T],
    work: impl Fn(&T) -> U + Send + Sync,
) -> Vec<U> {
    match pool {
        Some(pool) => pool.install(|| items.par_iter().map(work).collect()),
        None => items.iter().map(work).collect(),
    }
}
