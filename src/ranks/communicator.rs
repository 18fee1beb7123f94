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
}
