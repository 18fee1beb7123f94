//! Bodies that are held together by interfaces that break: found where nothing is deformed, and damaged step by step.
//!
//! `held` (all of a contact) · `carried` (damage where points are found anew) · `results` (what hosts read)

mod carried;
mod held;
mod results;

pub(super) use carried::nearest;
pub(super) use held::Cohesions;
pub(super) use results::Breaking;
pub use results::{CohesivePoint, CohesiveSummary};
