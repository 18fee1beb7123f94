//! What the depth of a body sums up to over an overlap, and how that changes as its cells move.

use super::cell_pieces::CellPieces;
use crate::depth_field::MOST_NODES;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::{Vector, Weighting};
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::overlap::sums::block_sum::{BlockSum, product};
use crate::overlap::sums::node_sums::NodeSums;

/// ∫ of every product of two barycentric coordinates.
pub(crate) type Products = [[f64; 4]; 4];

/// Volume of the overlap and the integral of the depth over it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct CellIntegrals {
    pub(crate) volume: f64,
    pub(crate) depth: f64,
}

/// Moments of the overlap in the barycentric coordinates of every piece of a body.
pub(crate) struct CellMoments {
    /// ∫ of every coordinate, weighted.
    pub(crate) first: Vec<[f64; 4]>,
    /// ∫ of the products of two, not weighted; empty where there is no weight.
    pub(crate) products: Vec<Products>,
}

impl CellMoments {
    /// Without a weight.
    pub(crate) fn plain(first: Vec<[f64; 4]>) -> Self {
        Self { first, products: Vec::new() }
    }

    /// With a weight, which is linear in every piece.
    pub(crate) fn weighted<const D: usize>(
        pieces: &CellPieces<D>,
        products: Vec<Products>,
        weighting: Weighting,
    ) -> Self {
        let first = pieces.pieces.iter().zip(&products).map(|(piece, products)| {
            let weights = piece.corners.map(|x| weighting.at(&x));
            products.map(|row| (0..=D).map(|k| row[k] * weights[k]).sum())
        });
        Self { first: first.collect(), products }
    }
}

/// Sums over the pieces of a body; adds the gradient and, if asked for, the second derivative, times `weight`. The
/// semidefinite part has no share here.
pub(crate) fn cell_integrals<const D: usize>(
    cells: &Cells,
    pieces: &CellPieces<D>,
    moments: &CellMoments,
    (of_b, weight): (bool, f64),
    (second, weighting): (SecondDerivative, Weighting),
    gradient: &mut NodeSums<D>,
    hessian: &mut BlockSum<D>,
) -> CellIntegrals {
    let mut sums = CellIntegrals::default();
    let mut values = Vec::new();
    let numbered = pieces.pieces.iter().zip(&moments.first).enumerate();
    for (number, (piece, first)) in numbered.filter(|(_, (_, m))| m.iter().any(|m| *m != 0.0)) {
        sums.volume += if piece.is_below_tie { 0.0 } else { first.iter().sum::<f64>() };
        sums.depth += first.iter().zip(&piece.depths).map(|(m, g)| m * g).sum::<f64>();
        let nodes = cells.nodes(piece.cell as usize);
        let at_nodes = piece.at_nodes(first);
        for (&node, m) in nodes.iter().zip(&at_nodes) {
            gradient.add(node, of_b, &(piece.gradient * (-weight * m)));
        }
        if second == SecondDerivative::Full {
            let slopes: [Vector<D>; MOST_NODES] = std::array::from_fn(|n| {
                (0..=D).fold(Vector::zeros(), |sum, k| sum + piece.slopes[k] * piece.weights[k][n])
            });
            let g = &piece.gradient;
            values.clear();
            for m in &at_nodes[..nodes.len()] {
                for slope in &slopes[..nodes.len()] {
                    let factor = -weight * m;
                    values.push(std::array::from_fn(|i| {
                        std::array::from_fn(|j| factor * (g[i] * slope[j] - g[j] * slope[i]))
                    }));
                }
            }
            if let Some(products) = moments.products.get(number) {
                // The weight of what moves changes.
                let slope = weighting.gradient::<D>();
                for (row, of_row) in (0..nodes.len()).map(|n| (n, piece.weights.map(|w| w[n]))) {
                    let along: [f64; 4] =
                        std::array::from_fn(|l| (0..=D).map(|k| of_row[k] * products[k][l]).sum::<f64>());
                    for (value, m) in values[row * nodes.len()..].iter_mut().zip(&piece.at_nodes(&along)[..nodes.len()])
                    {
                        for (sums, more) in value.iter_mut().zip(product(-weight * m, g, &slope)) {
                            sums.iter_mut().zip(more).for_each(|(sum, x)| *sum += x);
                        }
                    }
                }
            }
            hessian.add_square(nodes, &values);
        }
    }
    sums
}
