//! What a host gives so that its ranks can share the work.

/// Ranks of a parallel program, as a host's message passing library has them. It moves bytes and sums nothing: sums are formed
/// in a fixed order, whatever the number of ranks.
///
/// It is called on the thread that evaluates, in the same order on all ranks.
pub trait Communicator: Send + Sync {
    /// Number of this rank, from 0.
    fn rank(&self) -> usize;

    /// Number of ranks, at least 1.
    fn size(&self) -> usize;

    /// Sends bytes to all ranks, this one too, and receives what they send, one after the other in the order of the ranks;
    /// rank r sends `counts[r]` bytes, and `received` has room for all of them.
    ///
    /// # Errors
    /// A number of the host's own where it failed; the evaluation then ends with
    /// [`Error::Communication`](crate::Error::Communication).
    fn all_gather(&self, send: &[u8], counts: &[usize], received: &mut [u8]) -> Result<(), i32>;

    /// The operation by which ranks send to single others, where the host has it, on all ranks or on none. By default it has
    /// none, and what is for one rank goes to all.
    fn all_to_all(&self) -> Option<&dyn AllToAll> {
        None
    }
}

/// What ranks have for one another, each something else for each.
pub trait AllToAll {
    /// Sends bytes to every rank, this one too, and receives what they have for this one: `send` has `send_counts[r]` bytes for
    /// rank r, one rank after the other, and `received` gets `received_counts[r]` of rank r.
    ///
    /// # Errors
    /// As [`Communicator::all_gather`].
    fn all_to_all(
        &self,
        send: &[u8],
        send_counts: &[usize],
        received_counts: &[usize],
        received: &mut [u8],
    ) -> Result<(), i32>;
}
