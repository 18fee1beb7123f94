//! Sums that many threads and ranks add to, in a fixed order: over nodes, and over pairs of nodes.

pub(crate) mod block_sum;
pub(crate) mod node_sums;
