//! Bodies of revolution: cells of the meridian section (r, z), integrated over the whole ring.
//!
//! The third axis is that of the hoop. With nothing that turns, H has u_r/r there, so that
//!
//! ```text
//! f_a = ∫ (P ∇N_a + P_θθ N_a/r e_r) 2πr dr dz
//! ```

use super::elements::{Cell, Elements};
use super::response::Response;
use super::tensor::{Tensor, from_fn};

/// H in space, by the displacements of a cell's nodes.
#[inline(always)]
pub(super) fn gradient<const D: usize>(u: &[[f64; D]], gradients: &[[f64; D]], hoops: &[f64]) -> Tensor<3> {
    let mut h = [[0.0; 3]; 3];
    for ((u, gradient), hoop) in u.iter().zip(gradients).zip(hoops) {
        for i in 0..D {
            (0..D).for_each(|j| h[i][j] += u[i] * gradient[j]);
        }
        h[2][2] += u[0] * hoop;
    }
    h
}

/// Adds the forces of stresses at the Gauss points of a cell.
#[inline(always)]
pub(super) fn add_forces<const D: usize, const N: usize>(
    cell: &Cell<D, N>,
    f: &mut [[f64; D]; N],
    mut stress: impl FnMut(&[[f64; D]; N], &[f64; N], f64) -> Tensor<3>,
) {
    for ((gradients, hoops), &volume) in cell.gradients.iter().zip(cell.hoops).zip(cell.volumes) {
        let stress = stress(gradients, hoops, volume);
        for node in 0..N {
            for i in 0..D {
                f[node][i] += volume * (0..D).map(|j| stress[i][j] * gradients[node][j]).sum::<f64>();
            }
            f[node][0] += volume * stress[2][2] * hoops[node];
        }
    }
}

impl<const D: usize> Elements<D> {
    /// Adds a Gauss point's part to the upper half of a cell's stiffness.
    pub(super) fn add_ring_stiffness(
        &self,
        response: &Response,
        (point, nodes): (usize, &[u32]),
        displacement: &[[f64; D]],
        matrix: &mut [f64],
    ) {
        let (count, size) = (nodes.len(), nodes.len() * D);
        let gradients = &self.gradients[point * count..][..count];
        let hoops = &self.hoops[point * count..][..count];
        let tangent = response.tangent(&self.gradient_in_space(point, nodes, displacement));
        for column in 0..size {
            let (b, k) = (column / D, column % D);
            let stress: Tensor<3> = from_fn(|i, j| {
                let along = (0..D).map(|l| tangent[k][l][i][j] * gradients[b][l]).sum::<f64>();
                let around = if k == 0 { tangent[2][2][i][j] * hoops[b] } else { 0.0 };
                (along + around) * self.volumes[point]
            });
            for row in 0..=column {
                let (a, i) = (row / D, row % D);
                let around = if i == 0 { stress[2][2] * hoops[a] } else { 0.0 };
                matrix[row * size + column] += (0..D).map(|j| stress[i][j] * gradients[a][j]).sum::<f64>() + around;
            }
        }
    }

    /// H in space at a Gauss point, counted over all cells, of the cell with `nodes`. In plane strain nothing moves along z, nor with z.
    pub(super) fn gradient_in_space(&self, point: usize, nodes: &[u32], displacement: &[[f64; D]]) -> Tensor<3> {
        if self.is_ring() {
            let u: Vec<[f64; D]> = nodes.iter().map(|&node| displacement[node as usize]).collect();
            let range = point * nodes.len()..(point + 1) * nodes.len();
            return gradient(&u, &self.gradients[range.clone()], &self.hoops[range]);
        }
        let h = self.displacement_gradient(point, nodes, displacement);
        from_fn(|i, j| if i < D && j < D { h[i][j] } else { 0.0 })
    }
}
