//! The area of the surface that belongs to each node.

use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{Surface, Vector, Weighting};

impl<const D: usize> Surface<D> {
    /// ∫ N dA over all facets at each node, N being its shape function; in axisymmetry over the rings.
    pub(crate) fn shares(&self, coords: &[[f64; D]], weighting: Weighting) -> Vec<f64> {
        let mut shares = vec![0.0; coords.len()];
        let place = |vertex: u32| {
            let nodes = self.nodes_of_vertex(vertex);
            nodes.fold(Vector::zeros(), |x, (node, weight)| x + Vector::from(coords[node as usize]) * weight)
        };
        for facet in &self.facets {
            self.shares_of_facet(facet, place, weighting, |node, share| shares[node as usize] += share);
        }
        shares
    }

    /// Calls `visit(node, ∫ N dA)` for a facet with its vertices in these places.
    pub(crate) fn shares_of_facet(
        &self,
        facet: &[u32; D],
        place: impl Fn(u32) -> Vector<D>,
        weighting: Weighting,
        mut visit: impl FnMut(u32, f64),
    ) {
        let corners: [Vector<D>; D] = facet.map(place);
        let weights = corners.map(|x| weighting.at(&x));
        // Both are linear: ∫ of their product.
        let part = area_vector(&corners).norm() / (D * (D + 1)) as f64;
        let sum: f64 = weights.iter().sum();
        for (&vertex, weight) in facet.iter().zip(weights) {
            self.nodes_of_vertex(vertex).for_each(|(node, of_node)| visit(node, of_node * part * (sum + weight)));
        }
    }
}
