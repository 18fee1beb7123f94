//! The second derivative of what a facet has inside a piece of the other body.

use crate::depth_field::{DepthPiece, MOST_NODES};
use crate::geometry::Weighting;
use crate::geometry::cells::Cells;
use crate::geometry::facet::area_slopes;
use crate::overlap::pair::body_facet::{BodyFacet, FACET_NODES};
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::overlap::sums::block_sum::{BlockSum, product};

/// Nodes that take part where a facet lies in a cell.
pub(crate) const MOST: usize = FACET_NODES + MOST_NODES;

/// How the blocks of a side are formed.
pub(crate) struct FacetBlocks<'a> {
    pub(crate) cells: &'a Cells,
    /// Part with which the depth counts.
    pub(crate) weight: f64,
    pub(crate) weighting: Weighting,
    pub(crate) second: SecondDerivative,
}

impl FacetBlocks<'_> {
    /// Shape functions of the facet's nodes, then those of the cell's, at a point of both.
    pub(crate) fn shapes<const D: usize>(
        &self,
        facet: &BodyFacet<D>,
        piece: &DepthPiece<D>,
        on_facet: &[f64; D],
        in_piece: &[f64; 4],
    ) -> [f64; MOST] {
        let mut shapes = [0.0; MOST];
        for (weights, w) in facet.weights.iter().zip(on_facet) {
            shapes.iter_mut().zip(weights).for_each(|(sum, weight)| *sum += w * weight);
        }
        let of_cell = piece.at_nodes(in_piece);
        shapes[facet.nodes.len()..].iter_mut().zip(of_cell).for_each(|(shape, value)| *shape = value);
        shapes
    }

    /// Adds the second derivative of the integral over a facet inside a piece, given ∫ of products of shape functions
    /// and ∫ g N_a, in parts of its measure; and ∫ g N_a N_c without the weight, by which the weight counts that changes.
    pub(crate) fn add<const D: usize>(
        &self,
        facet: &BodyFacet<D>,
        piece: &DepthPiece<D>,
        products: &[[f64; MOST]; MOST],
        (moments, moved): (&[f64; D], &[[f64; D]; D]),
        values: &mut Vec<[[f64; D]; D]>,
        hessian: &mut BlockSum<D>,
    ) {
        let (n, g) = (&facet.normal, &piece.gradient);
        let semidefinite = self.second == SecondDerivative::Semidefinite;
        if semidefinite && (n.dot(g) <= 0.0 || piece.sign < 0.0) {
            return;
        }
        let mut nodes = facet.nodes.clone();
        nodes.extend_from_slice(self.cells.nodes(piece.cell as usize));
        let (own, count) = (facet.nodes.len(), nodes.len());
        values.clear();
        for row in 0..count {
            for col in 0..count {
                let opposite = if (row < own) == (col < own) { 1.0 } else { -1.0 };
                let factor = opposite * self.weight * facet.measure * products[row][col];
                values.push(match () {
                    () if semidefinite => product(factor * g.norm(), n, n),
                    () if row < own => product(factor, n, g),
                    () => product(factor, g, n),
                });
            }
        }
        if !semidefinite {
            let outwards = (!self.weighting.is_plain()).then(|| product(facet.measure, n, &self.weighting.gradient()));
            for (a, &moment) in moments.iter().enumerate() {
                for (c, slope) in area_slopes(&facet.corners).iter().enumerate() {
                    for row in 0..own {
                        for col in 0..own {
                            let factor = self.weight * moment * facet.weights[a][row] * facet.weights[c][col];
                            add_to(&mut values[row * count + col], factor, slope);
                            if let Some(outwards) = &outwards {
                                let factor = self.weight * moved[a][c] * facet.weights[a][row] * facet.weights[c][col];
                                add_to(&mut values[row * count + col], factor, outwards);
                            }
                        }
                    }
                }
            }
        }
        hessian.add_square(&nodes, values);
    }
}

fn add_to<const D: usize>(sums: &mut [[f64; D]; D], factor: f64, block: &[[f64; D]; D]) {
    for (sums, block) in sums.iter_mut().zip(block) {
        sums.iter_mut().zip(block).for_each(|(sum, x)| *sum += factor * x);
    }
}
