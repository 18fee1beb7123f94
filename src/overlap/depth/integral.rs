//! Depth summed over an overlap, which is what the law `depth` stands on.

use super::points::PointLists;
use crate::geometry::Vector;
use crate::overlap::pair::overlap::{MotionGradient, Overlap};
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::overlap::pair::sides::Pair;
use crate::overlap::sums::block_sum::Block;
use crate::ranks::packed;

/// What is asked for beside the value and its gradient.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthRequest {
    pub(crate) second: SecondDerivative,
    /// Number of the translation of the pair's obstacle in the second derivative.
    pub(crate) obstacle_node: u32,
    /// Whether the points where the forces act are asked for.
    pub(crate) points: bool,
}

/// J = ½ ∫ (g_A + g_B) over A ∩ B, the mean of the depths below both surfaces; against an obstacle ∫ g, the depth below its
/// surface alone.
#[derive(Clone, Debug)]
pub(crate) struct DepthIntegral<const D: usize> {
    /// J.
    pub(crate) value: f64,
    /// ∂J/∂x of these nodes, ascending; one that both sides have comes once for each.
    pub(crate) nodes: Vec<u32>,
    pub(crate) of_b: Vec<bool>,
    pub(crate) gradient: Vec<Vector<D>>,
    pub(crate) pose_gradient: Option<MotionGradient<D>>,
    /// Its second derivative, as blocks sorted by row and column.
    pub(crate) hessian: Vec<Block<D>>,
    /// What the facets have inside the other side.
    pub(crate) facets: Vec<FacetDepth<D>>,
    /// Where its forces act, by side and by facet; empty where that is not asked for.
    pub(crate) points: PointLists<D>,
    /// Depth of the boundaries of A ∩ B, each below the other surface, as a mean over their area.
    pub(crate) mean_depth: f64,
    /// Volume, area and what else is told of an overlap; its gradient is empty.
    pub(crate) overlap: Overlap<D>,
}

/// What a facet has inside the other side: ∫ N dA and ∫ N g dA over that part, N being barycentric coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FacetDepth<const D: usize> {
    /// Index within its side.
    pub(crate) facet: u32,
    pub(crate) of_b: bool,
    pub(crate) areas: [f64; D],
    pub(crate) depths: [f64; D],
}

packed!(FacetDepth<D> { facet, of_b, areas, depths });

impl<const D: usize> DepthIntegral<D> {
    /// Calls `visit(node, ∫ N dA, ∫ N g dA)` for the nodes of every facet, N being their shape functions.
    pub(crate) fn for_each_share(&self, pair: &Pair<D>, mut visit: impl FnMut(u32, f64, f64)) {
        for found in &self.facets {
            let vertices = pair.side(found.of_b).facets[found.facet as usize];
            for ((vertex, area), depth) in vertices.into_iter().zip(found.areas).zip(found.depths) {
                pair.surface.nodes_of_vertex(vertex).for_each(|(node, part)| visit(node, part * area, part * depth));
            }
        }
    }

    /// Moves the gradient on inner nodes to the nodes of the facets that are nearest to them without deformation, so that
    /// the sum of the forces stays as it is.
    pub(crate) fn bring_to_surface(&mut self, pair: &Pair<D>) {
        let Some(field) = pair.depth else { return };
        let mut moved: Vec<((u32, bool), Vector<D>)> = Vec::with_capacity(self.nodes.len());
        for ((&node, &of_b), gradient) in self.nodes.iter().zip(&self.of_b).zip(&self.gradient) {
            match field.anchor(pair.surface, node) {
                None => moved.push(((node, of_b), *gradient)),
                Some(anchor) => moved.extend(anchor.map(|(node, weight)| ((node, of_b), gradient * weight))),
            }
        }
        // Stable: what comes to one node is added in the order of the nodes from which it comes.
        moved.sort_by_key(|(place, _)| *place);
        moved.dedup_by(|next, sum| {
            let same = next.0 == sum.0;
            if same {
                sum.1 += next.1;
            }
            same
        });
        self.nodes = moved.iter().map(|((node, _), _)| *node).collect();
        self.of_b = moved.iter().map(|((_, of_b), _)| *of_b).collect();
        self.gradient = moved.into_iter().map(|(_, gradient)| gradient).collect();
    }
}
