//! Overlap of two bodies, by two estimators that return the same types.
//!
//! `pair` (two sides and their overlap) · `points` (contact points, for local laws) · `patches` (where a pair touches) ·
//! `exact` and `fibers` (the estimators, which do not know each other).

pub(crate) mod exact;
pub(crate) mod fibers;
pub(crate) mod pair;
pub(crate) mod patches;
pub(crate) mod points;

pub(crate) use exact::clipping::volume::ExactPair;
pub(crate) use fibers::layout::FiberPair;
pub use fibers::trace::FiberTrace;
pub use pair::options::{Estimator, FiberOptions, LineWeights, Resolution};
pub use pair::overlap::{Overlap, PoseGradient};
pub use pair::partner::Partner;
pub(crate) use pair::sides::{Counterpart, FacetSide, ImplicitSide, Pair, Views};
pub use pair::warning::Warning;
pub(crate) use patches::partition::Patches;
pub(crate) use points::contact_points::ContactPoints;
pub use points::hessian::Block;
pub(crate) use points::hessian::merged;
