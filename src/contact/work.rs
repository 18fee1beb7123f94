//! Who shares the work of a contact: `workers` (its threads) · `sharing` (these, and ranks)

mod sharing;
mod workers;

pub(super) use sharing::Work;
