//! What the depth of a body sums up to over an overlap, and how that changes as its cells move.

use super::cell_pieces::CellPieces;
use crate::depth::MOST_NODES;
use crate::geometry::Vector;
use crate::geometry::cells::Cells;
use crate::overlap::depth_integral::SecondDerivative;
use crate::overlap::points::block_sum::BlockSum;
use crate::overlap::points::node_sums::NodeSums;

/// Volume of the overlap and the integral of the depth over it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct CellIntegrals {
    pub(crate) volume: f64,
    pub(crate) depth: f64,
}

/// Sums over the pieces of a body, given ∫ of the barycentric coordinates of each over the overlap; adds the gradient
/// and, if asked for, the second derivative, times `weight`. The semidefinite part has no share here.
pub(crate) fn cell_integrals<const D: usize>(
    cells: &Cells,
    pieces: &CellPieces<D>,
    moments: &[[f64; 4]],
    (of_b, weight): (bool, f64),
    second: SecondDerivative,
    gradient: &mut NodeSums<D>,
    hessian: &mut BlockSum<D>,
) -> CellIntegrals {
    let mut sums = CellIntegrals::default();
    let mut values = Vec::new();
    for (piece, moments) in pieces.pieces.iter().zip(moments).filter(|(_, m)| m.iter().any(|m| *m != 0.0)) {
        sums.volume += moments.iter().sum::<f64>();
        sums.depth += moments.iter().zip(&piece.depths).map(|(m, g)| m * g).sum::<f64>();
        let nodes = cells.nodes(piece.cell as usize);
        let at_nodes = piece.at_nodes(moments);
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
            hessian.add_square(nodes, &values);
        }
    }
    sums
}
