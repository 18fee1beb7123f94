//! Bodies that are tied: their ties, found where nothing is deformed, and what holds them beside the stiffness of the pair.

mod held;
mod results;

pub(super) use held::{TieChange, TieKept, TieMultipliers, Ties};
pub use results::{TieConstraints, TieNode, TieSummary};
