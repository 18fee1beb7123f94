//! The second derivative of the depth of a point of a facet below another body.

use crate::depth_field::{DepthPiece, MOST_NODES, Quadratic};
use crate::geometry::Vector;
use crate::geometry::mesh::cells::Cells;
use crate::overlap::pair::body_facet::{BodyFacet, FACET_NODES};
use crate::overlap::sums::block_sum::BlockSum;

const MOST: usize = MOST_NODES + FACET_NODES;

/// Sums of the blocks of one facet, cell by cell of the other body.
#[derive(Default)]
pub(super) struct PointBlocks<const D: usize>(Vec<InCell<D>>);

struct InCell<const D: usize> {
    cell: u32,
    nodes: Vec<u32>,
    values: Vec<[[f64; D]; D]>,
}

/// A point, and how its depth changes.
pub(super) struct PointSlopes<'a, const D: usize> {
    pub(super) piece: &'a DepthPiece<D>,
    pub(super) heights: &'a Quadratic,
    /// Barycentric coordinates on the facet, and in the piece.
    pub(super) on_facet: &'a [f64; D],
    pub(super) in_piece: &'a [f64; 4],
    /// Gradient of the depth.
    pub(super) gradient: &'a Vector<D>,
}

impl<const D: usize> PointBlocks<D> {
    /// Adds f · ∂²g + q · ∂g ∂gᵀ of the depth g of a point.
    ///
    /// With r = x − Σ β_k c_k of the point against the corners c of the piece, ∇ the gradients of their coordinates β and d that of the
    /// depth, δg = d·r and δ²g = rᵀ (Σ ∂²g/∂β∂β ∇∇ᵀ) r − 2 Σ_k (d·δc_k)(∇β_k·r).
    ///
    /// `border`: the outward normal of a border of the piece at which the point lies, by how fast that cuts the facet, and the force there
    /// by length. The border moves along the facet as the point moves against the piece; what one piece loses is another's, so that
    /// pieces with one gradient add nothing.
    pub(super) fn add(
        &mut self,
        cells: &Cells,
        facet: &BodyFacet<D>,
        point: &PointSlopes<D>,
        (f, q): (f64, f64),
        border: Option<Vector<D>>,
    ) {
        let piece = point.piece;
        let of_cell = cells.nodes(piece.cell as usize);
        let place = self.0.iter().position(|known| known.cell == piece.cell).unwrap_or_else(|| {
            let nodes: Vec<u32> = facet.nodes.iter().chain(of_cell).copied().collect();
            let values = vec![[[0.0; D]; D]; nodes.len() * nodes.len()];
            self.0.push(InCell { cell: piece.cell, nodes, values });
            self.0.len() - 1
        });
        let InCell { nodes, values, .. } = &mut self.0[place];
        let (own, count) = (facet.nodes.len(), nodes.len());
        let (mut by, mut slopes) = ([0.0; MOST], [Vector::<D>::zeros(); MOST]);
        for (n, by) in by[..own].iter_mut().enumerate() {
            *by = (0..D).map(|c| point.on_facet[c] * facet.weights[c][n]).sum();
        }
        let at_nodes = piece.at_nodes(point.in_piece);
        for n in own..count {
            by[n] = -at_nodes[n - own];
            slopes[n] = (0..=D).fold(Vector::zeros(), |sum, k| sum + piece.slopes[k] * piece.weights[k][n - own]);
        }
        let d = point.gradient;
        let mut bent = [[0.0; D]; D];
        point.heights.for_each_second(|k, l, second| {
            let (p, r) = (&piece.slopes[k], &piece.slopes[l]);
            for (i, row) in bent.iter_mut().enumerate() {
                for (j, value) in row.iter_mut().enumerate() {
                    *value += second * (p[i] * r[j] + r[i] * p[j]);
                }
            }
        });
        let border = border.unwrap_or_else(Vector::zeros);
        let base: [[f64; D]; D] =
            std::array::from_fn(|i| std::array::from_fn(|j| q * d[i] * d[j] + f * bent[i][j] - d[i] * border[j]));
        for (row, of_row) in values.chunks_exact_mut(count).enumerate() {
            for (col, value) in of_row.iter_mut().enumerate() {
                let both = by[row] * by[col];
                for i in 0..D {
                    for j in 0..D {
                        let turned = by[row] * slopes[col][i] * d[j] + by[col] * d[i] * slopes[row][j];
                        value[i][j] += both * base[i][j] - f * turned;
                    }
                }
            }
        }
    }

    /// Adds all of them to a matrix; none is left.
    pub(super) fn add_to(&mut self, hessian: &mut BlockSum<D>) {
        self.0.drain(..).for_each(|InCell { nodes, values, .. }| hessian.add_square(&nodes, &values));
    }
}
