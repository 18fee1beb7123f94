//! What the facets of a body have inside the other side, summed.

use crate::overlap::depth::integral::FacetDepth;
use crate::overlap::depth::points::PointLists;
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::overlap::Overlap;
use crate::overlap::pair::sides::Pair;
use crate::overlap::sums::block_sum::BlockSum;
use crate::overlap::sums::node_sums::NodeSums;
use crate::ranks::packed;

/// Sums over facets, in the order in which they come.
#[derive(Default)]
pub(crate) struct FacetSums<const D: usize> {
    pub(crate) gradient: NodeSums<D>,
    pub(crate) hessian: BlockSum<D>,
    /// What every facet has inside.
    pub(crate) facets: Vec<FacetDepth<D>>,
    /// Where its forces act, if that is asked for.
    pub(crate) points: PointLists<D>,
    /// Their measure, the integral of the depth over it, and the largest depth.
    pub(crate) area: f64,
    pub(crate) depth: f64,
    pub(crate) deepest: f64,
    pub(crate) piece_count: usize,
    /// Measure of what lies in a face of the other side that looks the same way.
    pub(crate) flush: f64,
}

packed!(FacetSums<D> { gradient, hessian, facets, points, area, depth, deepest, piece_count, flush });

impl<const D: usize> FacetSums<D> {
    /// Takes what a facet has inside: ∫ N_a and ∫ g N_a, in parts of its measure.
    pub(crate) fn add_facet(&mut self, facet: &BodyFacet<D>, areas: &[f64; D], depths: &[f64; D], of_b: bool) {
        let in_measure = |sums: &[f64; D]| sums.map(|sum| sum * facet.measure);
        let (areas, depths) = (in_measure(areas), in_measure(depths));
        self.facets.push(FacetDepth { facet: facet.number, of_b, areas, depths });
    }

    /// Adds a facet of one side to its nodes, given ∫ N_a and ∫ g N_a over what it has inside, in parts of its measure; its
    /// force counts by `weight`.
    pub(crate) fn add_to_nodes(
        &mut self,
        facet: &BodyFacet<D>,
        areas: &[f64; D],
        depths: &[f64; D],
        (of_b, weight): (bool, f64),
    ) {
        // Of a facet on which nothing counts but what a tie leaves, there is a force alone.
        let is_told = areas.iter().any(|area| *area != 0.0) || depths.iter().all(|depth| *depth == 0.0);
        if is_told {
            self.add_facet(facet, areas, depths, of_b);
        }
        for (corner, weights) in facet.weights.iter().enumerate() {
            let force = facet.normal * (weight * (depths[corner] * facet.measure));
            for (&node, &part) in facet.nodes.iter().zip(weights).filter(|(_, part)| **part != 0.0) {
                self.gradient.add(node, of_b, &(force * part));
            }
        }
    }

    /// The sum of several parts, in their order.
    pub(crate) fn of_parts(parts: impl IntoIterator<Item = Self>) -> Self {
        parts.into_iter().fold(Self::default(), |mut sum, part| {
            sum.gradient.add_sums(&part.gradient);
            sum.hessian.add_sum(part.hessian);
            sum.facets.extend(part.facets);
            sum.points.append(part.points);
            sum.area += part.area;
            sum.depth += part.depth;
            sum.deepest = sum.deepest.max(part.deepest);
            sum.piece_count += part.piece_count;
            sum.flush += part.flush;
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
            facet_count: self.facets.len(),
            spacing: 0.0,
            warnings: Vec::new(),
        })
    }
}
