//! Overlap volume and its gradient, by two estimators that return one type.

mod assembly;
mod bundle;
mod clip;
mod estimate;
mod exact;
mod exact_creases;
mod exact_spans;
mod fiber_spans;
mod fibers;
mod gather;
mod hessian;
mod implicit;
mod layout;
mod options;
mod patch;
mod region;
mod resolution;
mod side;
mod solid;
mod span;
mod sweep;
mod warning;

pub use estimate::{FiberTrace, Overlap, Partner, PoseGradient};
pub(crate) use exact::ExactPair;
pub use hessian::Block;
pub(crate) use hessian::merged;
pub(crate) use layout::FiberPair;
pub use options::{Estimator, FiberOptions, LineWeights, Resolution};
pub(crate) use patch::Patches;
pub(crate) use side::{FacetSide, ImplicitSide, Opponent, Pair, Views};
pub(crate) use span::Spans;
pub use warning::Warning;
