//! Depth summed over an overlap, which is what the law `depth` stands on.

use super::pair::overlap::{Overlap, PoseGradient};
use super::points::block_sum::Block;
use crate::geometry::Vector;

/// Which derivatives are asked for beside the gradient.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SecondDerivative {
    /// None.
    No,
    /// A positive semidefinite part.
    Semidefinite,
    /// All of it.
    Full,
}

/// J = ∫ over A ∩ B of the mean of the depths below both surfaces, or of the depth below an obstacle's alone.
#[derive(Clone, Debug)]
pub(crate) struct DepthIntegral<const D: usize> {
    /// J.
    pub(crate) value: f64,
    /// ∂J/∂x of these nodes, ascending; one that both sides have comes once for each.
    pub(crate) nodes: Vec<u32>,
    pub(crate) of_b: Vec<bool>,
    pub(crate) gradient: Vec<Vector<D>>,
    pub(crate) pose_gradient: Option<PoseGradient<D>>,
    /// Its second derivative, as blocks sorted by row and column.
    pub(crate) hessian: Vec<Block<D>>,
    /// Depth of the boundaries of A ∩ B, each below the other surface, as a mean over their area.
    pub(crate) mean_depth: f64,
    /// Volume, area and what else is told of an overlap; its gradient is empty.
    pub(crate) overlap: Overlap<D>,
}
