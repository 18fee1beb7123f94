//! Work that the ranks of a parallel program share.
//!
//! Every rank has all bodies at the same coordinates. What is measured piece by piece, clipped facets, lines, cells, is divided
//! among the ranks, and what each found is gathered on all of them in the order in which one rank would have found it. From
//! there on all do the same, with the same bits as one rank alone.
//!
//! `communicator` (what a host gives) · `packed` (results as bytes) · `shared_work` (who does what, and that all agree) ·
//! `exchange` (what is for single ranks) · `sharing` (by which the rest of the code asks for it) · `interrupt` (the end of what takes
//! long, as a caller wishes).

mod communicator;
mod exchange;
mod interrupt;
mod packed;
mod shared_work;
mod sharing;

pub use communicator::{AllToAll, Communicator};
pub use interrupt::Asked;
pub(crate) use interrupt::{Interrupt, caught, on_threads_of};
pub(crate) use packed::{Packed, packed};
pub use shared_work::RankCounts;
pub(crate) use shared_work::Ranks;
pub(crate) use sharing::Sharing;
