//! Bodies that are held together by interfaces that break: found where nothing is deformed, and damaged step by step.

mod held;
mod results;

pub(super) use held::{Cohesions, Damage};
pub use results::{CohesivePoint, CohesiveSummary};
