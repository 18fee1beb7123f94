//! Stiffness of single elements.

use super::elements::Elements;
use super::response::Response;
use super::tensor::{Tensor, from_fn};

impl<const D: usize> Elements<D> {
    /// Stiffness of one cell at `displacement` of the model's nodes, by rows of node · D + axis, exactly symmetric:
    /// K_(ai)(bk) = ∫ ∇N_a · ∂P_i/∂H_k · ∇N_b dV.
    pub(super) fn stiffness(&self, response: &Response, cell: usize, displacement: &[[f64; D]], matrix: &mut Vec<f64>) {
        let count = self.cell_type.node_count();
        let size = count * D;
        let nodes = &self.conn[cell * count..][..count];
        matrix.clear();
        matrix.resize(size * size, 0.0);
        if let Some(modes) = &self.modes {
            self.add_bending(modes, response, cell, matrix);
            return mirror(size, matrix);
        }
        for point in cell * self.points_per_cell..(cell + 1) * self.points_per_cell {
            if self.is_ring() {
                self.add_ring_stiffness(response, (point, nodes), displacement, matrix);
                continue;
            }
            let gradients = &self.gradients[point * count..][..count];
            let tangent = response.tangent(&self.displacement_gradient(point, nodes, displacement));
            for column in 0..size {
                let (b, k) = (column / D, column % D);
                // Change of P, times dV, with component k of node b.
                let stress: Tensor<D> = from_fn(|i, j| {
                    (0..D).map(|l| tangent[k][l][i][j] * gradients[b][l]).sum::<f64>() * self.volumes[point]
                });
                for row in 0..=column {
                    let (a, i) = (row / D, row % D);
                    matrix[row * size + column] += (0..D).map(|j| stress[i][j] * gradients[a][j]).sum::<f64>();
                }
            }
        }
        mirror(size, matrix);
    }

    /// H at a Gauss point, counted over all cells of the part, of the cell with `nodes`.
    pub(super) fn displacement_gradient(&self, point: usize, nodes: &[u32], displacement: &[[f64; D]]) -> Tensor<D> {
        let gradients = &self.gradients[point * nodes.len()..][..nodes.len()];
        let mut h =
            from_fn(|i, j| nodes.iter().zip(gradients).map(|(&node, g)| displacement[node as usize][i] * g[j]).sum());
        if let Some(modes) = &self.modes {
            let u: Vec<[f64; D]> = nodes.iter().map(|&node| displacement[node as usize]).collect();
            modes.add(point, &modes.amplitudes(point / self.points_per_cell, &u), &mut h);
        }
        h
    }
}

/// Fills the lower half of a symmetric matrix.
fn mirror(size: usize, matrix: &mut [f64]) {
    for row in 0..size {
        (0..row).for_each(|column| matrix[row * size + column] = matrix[column * size + row]);
    }
}
