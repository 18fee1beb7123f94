//! Overlap volume and its gradient, by two estimators that return one type.

mod assembly;
mod bundle;
mod clip;
mod estimate;
mod exact;
mod fibers;
mod gather;
mod implicit;
mod layout;
mod options;
mod region;
mod resolution;
mod side;
mod solid;
mod span;
mod warning;

pub use estimate::{FiberTrace, Overlap, Partner, PoseGradient};
pub(crate) use exact::ExactPair;
pub(crate) use layout::FiberPair;
pub use options::{Estimator, FiberOptions, LineWeights, Resolution};
pub(crate) use side::{FacetSide, ImplicitSide, Opponent, Pair, Views};
pub use warning::Warning;
