//! Which rank does what, and that all ranks do the same.

use super::communicator::Communicator;
use super::packed::Packed;
use crate::Error;
use std::any::type_name;
use std::hash::Hasher;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard};

/// Chunks for each rank below which every rank does all of them: sending takes longer than the work.
const LEAST_CHUNKS: usize = 2;

/// What ranks did since they began to share the work: of this rank, but for `item_count`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RankCounts {
    /// Facets, lines' bundles, pieces of cells and pairs of facets that were divided among the ranks.
    pub item_count: u64,
    /// Those that this rank measured.
    pub own_item_count: u64,
    /// Calls of the communicator.
    pub call_count: u64,
    /// Bytes that this rank sent.
    pub sent_bytes: u64,
    /// Bytes that it received, its own too.
    pub received_bytes: u64,
}

/// The ranks that share the work of one contact.
pub(crate) struct Ranks {
    pub(super) communicator: Box<dyn Communicator>,
    rank: usize,
    pub(super) size: usize,
    counts: Mutex<RankCounts>,
    /// What went wrong first in the evaluation in hand.
    failure: Mutex<Option<Error>>,
    /// Whether a part of shared work is being done: what it divides again is its own.
    is_busy: AtomicBool,
}

impl Ranks {
    /// # Errors
    /// [`Error::BadRank`].
    pub(crate) fn new(communicator: Box<dyn Communicator>) -> Result<Self, Error> {
        let (rank, size) = (communicator.rank(), communicator.size());
        if rank >= size {
            return Err(Error::BadRank { rank, size });
        }
        let (counts, failure, is_busy) = (Mutex::default(), Mutex::default(), AtomicBool::new(false));
        Ok(Self { communicator, rank, size, counts, failure, is_busy })
    }

    /// What was counted.
    pub(crate) fn counts(&self) -> RankCounts {
        *self.counts.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    /// Whether so many chunks are worth being shared.
    pub(super) fn are_enough(&self, chunk_count: usize) -> bool {
        self.size > 1 && chunk_count >= LEAST_CHUNKS * self.size
    }

    /// Results of numbered chunks, in their order: `work` is given the numbers of those that are this rank's.
    ///
    /// Neighbours go to different ranks, so that what is dense somewhere is everybody's. Where something fails, this rank does
    /// what is missing by itself, and [`Self::agree`] reports it.
    pub(super) fn share<U: Packed>(
        &self,
        chunk_count: usize,
        item_count: usize,
        work: impl Fn(&[usize]) -> Vec<U>,
    ) -> Vec<U> {
        let all: Vec<usize> = (0..chunk_count).collect();
        if !self.are_enough(chunk_count) || self.is_busy.swap(true, Ordering::Relaxed) {
            return work(&all);
        }
        let own: Vec<usize> = (self.rank..chunk_count).step_by(self.size).collect();
        let found = work(&own);
        self.is_busy.store(false, Ordering::Relaxed);
        let mut send = Vec::new();
        for (number, value) in own.iter().zip(&found) {
            number.pack(&mut send);
            // The length stands before it, so that a value that is not there is skipped.
            let at = send.len();
            0usize.pack(&mut send);
            value.pack(&mut send);
            let length = send.len() - at - size_of::<usize>();
            send[at..at + size_of::<usize>()].copy_from_slice(&length.to_ne_bytes());
        }
        let share = (chunk_count - self.rank).div_ceil(self.size);
        self.count(|counts| {
            counts.item_count += item_count as u64;
            counts.own_item_count += (item_count * share / chunk_count) as u64;
        });
        let mut values: Vec<Option<U>> = (0..chunk_count).map(|_| None).collect();
        if let Some(received) = self.gather(&send, tag::<U>(chunk_count, item_count)) {
            let mut bytes = &received[..];
            while let (Some(number), Some(length)) = (usize::unpack(&mut bytes), usize::unpack(&mut bytes)) {
                let Some((mut value, rest)) = bytes.split_at_checked(length) else { break };
                bytes = rest;
                if number % self.size != self.rank
                    && let Some(place) = values.get_mut(number)
                {
                    *place = U::unpack(&mut value);
                }
            }
        }
        for (number, value) in own.into_iter().zip(found) {
            values[number] = Some(value);
        }
        let missing: Vec<usize> = all.into_iter().filter(|&number| values[number].is_none()).collect();
        for (number, value) in missing.iter().zip(work(&missing)) {
            values[*number] = Some(value);
        }
        values.into_iter().flatten().collect()
    }

    /// Number of this rank.
    pub(crate) fn rank(&self) -> usize {
        self.rank
    }

    /// Lists of all ranks, by rank.
    ///
    /// # Errors
    /// [`Error::Communication`], [`Error::RanksDiffer`].
    pub(crate) fn gather_lists<T: Packed>(&self, own: &[T]) -> Result<Vec<Vec<T>>, Error> {
        let mut send = Vec::new();
        own.len().pack(&mut send);
        own.iter().for_each(|item| item.pack(&mut send));
        let received = self.gather(&send, tag::<T>(0, 0));
        self.lists_in(received)
    }

    /// Lists of all ranks in what was received, or why there are none.
    pub(super) fn lists_in<T: Packed>(&self, received: Option<Vec<u8>>) -> Result<Vec<Vec<T>>, Error> {
        let failed = || self.failure().take().unwrap_or(Error::RanksDiffer { rank: self.rank });
        let received = received.ok_or_else(failed)?;
        let mut bytes = &received[..];
        (0..self.size).map(|_| Vec::unpack(&mut bytes).ok_or(Error::RanksDiffer { rank: self.rank })).collect()
    }

    /// The sum of a number that every rank gives.
    pub(super) fn total(&self, count: usize) -> usize {
        if self.size == 1 {
            return count;
        }
        let Some(received) = self.gather(&count.to_ne_bytes(), tag::<usize>(1, 1)) else { return count };
        let mut bytes = &received[..];
        std::iter::from_fn(|| usize::unpack(&mut bytes)).fold(0, usize::saturating_add)
    }

    /// Begins or ends an evaluation, on all ranks together: fails on all where it failed on one, or where the ranks were given
    /// different things, by the hash of what they were given.
    ///
    /// # Errors
    /// The one given; [`Error::Communication`], [`Error::OnOtherRank`], [`Error::RanksDiffer`].
    pub(crate) fn agree<T>(&self, found: Result<T, Error>, given: u64) -> Result<T, Error> {
        let mut send = Vec::new();
        [u64::from(found.is_err()), given].pack(&mut send);
        // Ranks that have found out that they differ have no more to say: the others may have gone on to here.
        let is_lost = self.has_failed();
        let received = if is_lost { None } else { self.all_gather(&send, &vec![send.len(); self.size]) };
        let failure = self.failure().take();
        let value = found?;
        if let Some(failure) = failure {
            return Err(failure);
        }
        let of_ranks: Vec<[u64; 2]> = received
            .unwrap_or_default()
            .chunks(send.len())
            .filter_map(|mut bytes| Packed::unpack(&mut bytes))
            .collect();
        if let Some(rank) = of_ranks.iter().position(|[failed, _]| *failed != 0) {
            return Err(Error::OnOtherRank { rank });
        }
        match of_ranks.iter().position(|[_, of_rank]| *of_rank != of_ranks[0][1]) {
            Some(rank) => Err(Error::RanksDiffer { rank }),
            None => Ok(value),
        }
    }

    /// What all ranks send, one after the other; `None` where it cannot be had, or the ranks do not do the same.
    fn gather(&self, send: &[u8], tag: u64) -> Option<Vec<u8>> {
        if self.has_failed() {
            return None;
        }
        let counts = self.lengths(send.len(), tag)?;
        self.all_gather(send, &counts)
    }

    /// How much all ranks are about to send; `None` as above.
    pub(super) fn lengths(&self, length: usize, tag: u64) -> Option<Vec<usize>> {
        let mut about = Vec::new();
        [length as u64, tag].pack(&mut about);
        let received = self.all_gather(&about, &vec![about.len(); self.size])?;
        let of_ranks: Vec<[u64; 2]> =
            received.chunks(about.len()).filter_map(|mut bytes| Packed::unpack(&mut bytes)).collect();
        if let Some(rank) = of_ranks.iter().position(|[_, other]| *other != tag) {
            self.fail(Error::RanksDiffer { rank });
            return None;
        }
        Some(of_ranks.iter().map(|[length, _]| *length as usize).collect())
    }

    fn all_gather(&self, send: &[u8], counts: &[usize]) -> Option<Vec<u8>> {
        self.received(send.len(), counts, |received| self.communicator.all_gather(send, counts, received))
    }

    /// What a function of the host leaves, so many bytes of every rank; `None` where it fails, which is kept for [`Self::agree`].
    pub(super) fn received(
        &self,
        sent: usize,
        counts: &[usize],
        function: impl FnOnce(&mut [u8]) -> Result<(), i32>,
    ) -> Option<Vec<u8>> {
        let mut received = vec![0; counts.iter().sum()];
        self.count(|sum| {
            sum.call_count += 1;
            sum.sent_bytes += sent as u64;
            sum.received_bytes += received.len() as u64;
        });
        match function(&mut received) {
            Ok(()) => Some(received),
            Err(code) => {
                self.fail(Error::Communication { code });
                None
            }
        }
    }

    pub(super) fn has_failed(&self) -> bool {
        self.failure().is_some()
    }

    fn fail(&self, error: Error) {
        self.failure().get_or_insert(error);
    }

    fn failure(&self) -> MutexGuard<'_, Option<Error>> {
        self.failure.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    fn count(&self, add: impl FnOnce(&mut RankCounts)) {
        add(&mut self.counts.lock().unwrap_or_else(|poisoned| poisoned.into_inner()));
    }
}

/// What is sent, and how many: ranks that do different things are found out.
pub(super) fn tag<U>(chunk_count: usize, item_count: usize) -> u64 {
    let mut hasher = rustc_hash::FxHasher::default();
    hasher.write(type_name::<U>().as_bytes());
    hasher.write_usize(chunk_count);
    hasher.write_usize(item_count);
    hasher.finish()
}
