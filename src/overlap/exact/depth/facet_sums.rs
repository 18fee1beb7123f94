//! What the facets of a body have inside the other side, summed.

use super::body_facet::BodyFacet;
use super::node_sums::NodeSums;
use crate::overlap::depth_integral::NodalDepth;
use crate::overlap::pair::overlap::Overlap;
use crate::overlap::pair::sides::Pair;
use crate::overlap::points::block_sum::BlockSum;

/// Sums over facets, in the order in which they come.
#[derive(Default)]
pub(crate) struct FacetSums<const D: usize> {
    pub(crate) gradient: NodeSums<D>,
    pub(crate) hessian: BlockSum<D>,
    /// What of it belongs to the nodes of every facet.
    pub(crate) shares: Vec<NodalDepth>,
    /// Their measure, the integral of the depth over it, and the largest depth.
    pub(crate) area: f64,
    pub(crate) depth: f64,
    pub(crate) deepest: f64,
    pub(crate) piece_count: usize,
    pub(crate) facet_count: usize,
}

impl<const D: usize> FacetSums<D> {
    /// Adds a facet of one side to its nodes, given ∫ N_a and ∫ g N_a over what it has inside, in parts of its measure; its
    /// force counts by `weight`.
    pub(crate) fn add_to_nodes(
        &mut self,
        facet: &BodyFacet<D>,
        areas: &[f64; D],
        depths: &[f64; D],
        (of_b, weight): (bool, f64),
    ) {
        self.facet_count += 1;
        for (corner, weights) in facet.weights.iter().enumerate() {
            let [area, depth] = [areas[corner], depths[corner]].map(|m| m * facet.measure);
            let force = facet.normal * (weight * depth);
            for (&node, &part) in facet.nodes.iter().zip(weights).filter(|(_, part)| **part != 0.0) {
                self.gradient.add(node, of_b, &(force * part));
                self.shares.push(NodalDepth { node, area: part * area, depth: part * depth });
            }
        }
    }

    /// The sum of several parts, in their order.
    pub(crate) fn of_parts(parts: impl IntoIterator<Item = Self>) -> Self {
        parts.into_iter().fold(Self::default(), |mut sum, part| {
            sum.gradient.add_sums(&part.gradient);
            sum.hessian.add_sum(part.hessian);
            sum.shares.extend(part.shares);
            sum.area += part.area;
            sum.depth += part.depth;
            sum.deepest = sum.deepest.max(part.deepest);
            sum.piece_count += part.piece_count;
            sum.facet_count += part.facet_count;
            sum
        })
    }

    /// What is told of the overlap, `None` if there is none; its gradient is empty.
    pub(crate) fn overlap(&self, pair: &Pair<D>, volume: f64, contact_area: f64) -> Option<Overlap<D>> {
        if self.piece_count == 0 && volume <= 0.0 {
            return None;
        }
        let [a, b] = pair.partners;
        Some(Overlap {
            a,
            b,
            volume: volume.max(0.0),
            standard_error: 0.0,
            nodes: Vec::new(),
            gradient: Vec::new(),
            of_b: Vec::new(),
            pose_gradient: None,
            contact_area,
            penetration: self.deepest,
            fiber_count: 0,
            crossing_count: self.piece_count,
            facet_count: self.facet_count,
            spacing: 0.0,
            warnings: Vec::new(),
        })
    }
}
