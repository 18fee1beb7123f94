//! Bodies that are tied: their ties, found where nothing is deformed, and what holds them beside the stiffness of the pair.

mod held;
mod results;
mod supports;

pub(super) use held::{HeldApart, TieChange, TieKept, TieMultipliers, Ties};
pub use results::{TieConstraints, TieNode, TieSummary};
pub(super) use supports::Supports;
