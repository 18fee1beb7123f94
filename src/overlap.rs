//! Overlap volume and its gradient, by two estimators that return one type.

mod around;
mod assembly;
mod bundle;
mod cell_simplices;
mod clearance;
mod clip;
mod clipper;
mod cover;
mod estimate;
mod exact;
mod exact_spans;
mod fiber_spans;
mod fibers;
mod gather;
mod implicit;
mod layout;
mod options;
mod patch;
mod piece;
mod region;
mod resolution;
mod side;
mod solid;
mod span;
mod sweep;
mod warning;

pub use estimate::{FiberTrace, Overlap, Partner, PoseGradient};
pub(crate) use exact::ExactPair;
pub(crate) use layout::FiberPair;
pub use options::{Estimator, FiberOptions, LineWeights, Resolution};
pub(crate) use patch::Patches;
pub(crate) use side::{FacetSide, ImplicitSide, Opponent, Pair, Views};
pub(crate) use span::Spans;
pub use warning::Warning;
