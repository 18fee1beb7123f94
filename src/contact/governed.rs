//! Bodies that are held together by interfaces with a law of the host: found where nothing is deformed, with a history step by step.
//!
//! `held` (all of a contact) · `results` (what hosts read)

mod held;
mod results;

pub(super) use held::{GovernedInterfaces, OwnLaw};
pub use results::LawPoint;
