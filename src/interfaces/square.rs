//! Second derivatives by the nodes that move one piece of an interface.

use super::cohesion::CohesivePoint;
use super::frame::Matrix;
use super::place::Weights;
use crate::overlap::BlockSum;
use std::collections::BTreeMap;

/// What points of one piece add to the second derivative.
#[derive(Default)]
pub(super) struct Square<const D: usize> {
    /// The nodes, as places in the list of the interface, and how they move the corners of the facet.
    pub(super) nodes: Vec<u32>,
    pub(super) corners: Vec<[f64; D]>,
    /// Those of the jump alone, and the facet, by which points of one piece are known.
    jump: Vec<u32>,
    frame: u32,
    pub(super) values: Vec<Matrix<D>>,
}

impl<const D: usize> Square<D> {
    pub(super) fn of(point: &CohesivePoint, corners: &[Weights; D]) -> Self {
        let mut of_node: BTreeMap<u32, [f64; D]> = point.jump.iter().map(|&(node, _)| (node, [0.0; D])).collect();
        for (corner, weights) in corners.iter().enumerate() {
            weights.iter().for_each(|&(node, weight)| of_node.entry(node).or_insert([0.0; D])[corner] += weight);
        }
        let jump = point.jump.iter().map(|(node, _)| *node).collect();
        let values = vec![[[0.0; D]; D]; of_node.len() * of_node.len()];
        let (nodes, corners) = of_node.into_iter().unzip();
        Self { nodes, corners, jump, frame: point.frame, values }
    }

    pub(super) fn is_of(&self, point: &CohesivePoint) -> bool {
        self.frame == point.frame && self.jump.iter().eq(point.jump.iter().map(|(node, _)| node))
    }

    pub(super) fn hand_over(&self, nodes: &[u32], sum: &mut BlockSum<D>) {
        let nodes: Vec<u32> = self.nodes.iter().map(|node| nodes[*node as usize]).collect();
        sum.add_square(&nodes, &self.values);
    }

    /// Shares of the nodes in the jump of a point.
    pub(super) fn weights(&self, point: &CohesivePoint) -> Vec<f64> {
        let mut weights = vec![0.0; self.nodes.len()];
        let mut places = 0..self.nodes.len();
        for &(node, weight) in &point.jump {
            // Both are ascending.
            if let Some(place) = places.find(|&place| self.nodes[place] == node) {
                weights[place] = weight;
            }
        }
        weights
    }
}

/// Σ shares · slopes.
pub(super) fn mixed<const D: usize>(shares: &[f64; D], slopes: &[Matrix<D>; D]) -> Matrix<D> {
    let entry = |i: usize, j: usize| shares.iter().zip(slopes).map(|(share, slope)| share * slope[i][j]).sum();
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}
