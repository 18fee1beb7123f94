//! Overlap of two bodies, law by law.
//!
//! `pair` (two sides and their overlap) · `gaps`, whatever the law · `sums` (over nodes) · `lines` (sampled) · `depth`, `volume`
//! and `normal_lines` (what the laws `depth`, `volume` and `fiber` stand on)

pub(crate) mod depth;
mod gaps;
pub(crate) mod lines;
pub(crate) mod normal_lines;
pub(crate) mod pair;
pub(crate) mod sums;
pub(crate) mod volume;

pub(crate) use depth::integral::{DepthIntegral, DepthRequest};
pub(crate) use depth::measure::depth_integral;
pub(crate) use depth::points::{DepthPlace, DepthPoint, PlaceInCell, PointLists, without_rounding};
pub(crate) use depth::{DepthSeeds, depth_slopes};
pub(crate) use gaps::{NodalGap, gap_points, nodal_gaps};
pub(crate) use lines::pair_estimator::PairEstimator;
pub(crate) use normal_lines::patches::partition::Patches;
pub(crate) use normal_lines::patches::search::{Reach, find as find_patches};
pub(crate) use normal_lines::points::contact_point::ContactPoint;
pub(crate) use normal_lines::points::contact_points::{ContactPoints, PointGradient};
pub(crate) use normal_lines::points::nodal_sums::{NodalSum, NodalSums};
pub use pair::fiber_trace::FiberTrace;
pub(crate) use pair::imbalance::Imbalance;
pub(crate) use pair::obstacle_distance::distance_from_facets;
pub(crate) use pair::obstacle_region::region as obstacle_region;
pub use pair::options::{Estimator, FiberOptions, LineWeights, Resolution};
pub(crate) use pair::overlap::MotionGradient;
pub use pair::overlap::{Overlap, PoseGradient};
pub use pair::partner::Partner;
pub(crate) use pair::second_derivative::SecondDerivative;
pub(crate) use pair::sides::{Counterpart, ImplicitSide, Offset, Pair, TiedFacets};
pub(crate) use pair::surface_point::SurfacePoint;
pub use pair::warning::{Smoothing, Warning};
pub use sums::block_sum::Block;
pub(crate) use sums::block_sum::{BlockSum, merged};
pub(crate) use sums::node_sums::NodeSums;
