//! Threads and ranks that share the work: `workers` (the threads of a contact) · `sharing` (the ranks)

mod sharing;
mod workers;

pub(super) use workers::Workers;
