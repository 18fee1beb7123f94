//! Overlap of two bodies, by two estimators that return the same types.
//!
//! `pair` (two sides and their overlap) · `points` (contact points, for local laws) · `patches` (where a pair touches)
//! · `depth` (the law `depth`) · `exact` and `fibers` (the estimators, which do not know each other).

mod auto;
mod by_options;
pub(crate) mod depth;
pub(crate) mod depth_integral;
pub(crate) mod depth_points;
pub(crate) mod estimator;
pub(crate) mod exact;
pub(crate) mod fibers;
mod gaps;
pub(crate) mod pair;
pub(crate) mod patches;
pub(crate) mod points;

pub(crate) use by_options::estimator;
pub(crate) use depth_integral::{DepthIntegral, DepthRequest, SecondDerivative};
pub(crate) use depth_points::{DepthPlace, DepthPoint, PlaceInCell, PointLists};
pub(crate) use estimator::{Imbalance, OverlapEstimator};
pub(crate) use exact::depth::depth_integral;
pub(crate) use gaps::{NodalGap, nodal_gaps};
pub use pair::fiber_trace::FiberTrace;
pub(crate) use pair::obstacle_distance::distance_from_facets;
pub(crate) use pair::obstacle_region::region as obstacle_region;
pub use pair::options::{Estimator, FiberOptions, LineWeights, Resolution};
pub use pair::overlap::{Overlap, PoseGradient};
pub use pair::partner::Partner;
pub(crate) use pair::sides::{Counterpart, ImplicitSide, Pair};
pub(crate) use pair::surface_point::SurfacePoint;
pub use pair::warning::Warning;
pub(crate) use patches::partition::Patches;
pub(crate) use patches::search::{Reach, find as find_patches};
pub use points::block_sum::Block;
pub(crate) use points::block_sum::{BlockSum, merged};
pub(crate) use points::contact_point::ContactPoint;
pub(crate) use points::contact_points::{ContactPoints, PointGradient};
pub(crate) use points::end_motion::nodes_of;
pub(crate) use points::nodal_sums::NodalSum;
pub(crate) use points::node_sums::NodeSums;
