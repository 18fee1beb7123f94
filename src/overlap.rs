//! Overlap volume and its gradient, by two estimators that return one type.

mod estimate;
mod options;
mod warning;

pub use estimate::{FiberTrace, Overlap, Partner, PoseGradient};
pub use options::{Estimator, FiberOptions, LineWeights, Resolution};
pub use warning::Warning;
