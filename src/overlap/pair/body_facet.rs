//! A facet of a body, and the nodes that move it.

use crate::configuration::FacetSide;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{Surface, Vector};

/// Nodes that move a facet: those of a quadrilateral face move each of its triangles.
pub(crate) const FACET_NODES: usize = 4;

/// A facet that has a measure.
pub(crate) struct BodyFacet<const D: usize> {
    /// Index within its side.
    pub(crate) number: u32,
    pub(crate) corners: [Vector<D>; D],
    pub(crate) area: Vector<D>,
    pub(crate) measure: f64,
    /// Unit outward normal.
    pub(crate) normal: Vector<D>,
    pub(crate) nodes: Vec<u32>,
    /// Weights of the nodes in each corner.
    pub(crate) weights: [[f64; FACET_NODES]; D],
}

impl<const D: usize> BodyFacet<D> {
    /// A facet of a side; `None` where it has no measure.
    pub(crate) fn new(surface: &Surface<D>, side: &FacetSide<D>, number: u32) -> Option<Self> {
        let corners = side.corners(number as usize);
        let area = area_vector(&corners);
        let measure = area.norm();
        if measure == 0.0 {
            return None;
        }
        let (mut nodes, mut weights) = (Vec::with_capacity(FACET_NODES), [[0.0; FACET_NODES]; D]);
        let mut place = |node: u32| {
            let known = nodes.iter().position(|n| *n == node);
            known.unwrap_or_else(|| {
                nodes.push(node);
                nodes.len() - 1
            })
        };
        for (weights, &vertex) in weights.iter_mut().zip(&side.facets[number as usize]) {
            for (node, weight) in surface.nodes_of_vertex(vertex) {
                weights[place(node)] += weight;
            }
        }
        Some(Self { number, corners, area, measure, normal: area / measure, nodes, weights })
    }
}
