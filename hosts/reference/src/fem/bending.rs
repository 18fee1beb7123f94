//! Cells that get incompatible modes, and their stiffness.

use super::elements::{Elements, inverse_transposed};
use super::modes::Modes;
use super::quadrature::gauss_points;
use super::response::Response;
use super::shape::CORNERS;
use super::tensor::{Tensor, contract, from_fn};
use super::{Law, Model};
use fmc_contact::CellType;
use nalgebra::DMatrix;

impl<const D: usize> Model<D> {
    /// The same with incompatible modes in the cells for which `has_modes` holds, counted over all parts: quadrilaterals and
    /// hexahedra of first order and linear laws, not of bodies of revolution. Other cells stay as they are.
    pub fn with_incompatible_modes(mut self, has_modes: impl Fn(usize) -> bool) -> Self {
        let mut first = 0;
        for elements in &mut self.elements {
            elements.modes = modes(elements, &self.coords, |cell| has_modes(first + cell));
            first += elements.len();
        }
        self
    }
}

impl<const D: usize> Elements<D> {
    /// Adds the upper half of the stiffness of a cell with modes, by rows of node · D + axis.
    pub(super) fn add_bending(&self, modes: &Modes<D>, response: &Response, cell: usize, matrix: &mut [f64]) {
        let count = self.cell_type.node_count();
        let size = count * D;
        let rows = &modes.amplitudes[cell * D * D * size..][..D * D * size];
        for point in cell * self.points_per_cell..(cell + 1) * self.points_per_cell {
            let gradients = &self.gradients[point * count..][..count];
            // H for a unit displacement of each degree of freedom.
            let of_freedom = |freedom: usize| -> Tensor<D> {
                let mut h = [[0.0; D]; D];
                h[freedom % D] = gradients[freedom / D];
                modes.add(point, &from_fn(|mode, axis| rows[(mode * D + axis) * size + freedom]), &mut h);
                h
            };
            let all: Vec<Tensor<D>> = (0..size).map(of_freedom).collect();
            for (column, h) in all.iter().enumerate() {
                let stress = response.stress_derivative(h, h).map(|row| row.map(|p| p * self.volumes[point]));
                (0..=column).for_each(|row| matrix[row * size + column] += contract(&stress, &all[row]));
            }
        }
    }
}

/// Modes of the cells for which `has_modes` holds; none where no cell can have any.
fn modes<const D: usize>(
    elements: &Elements<D>,
    coords: &[[f64; D]],
    has_modes: impl Fn(usize) -> bool,
) -> Option<Modes<D>> {
    let is_linear = matches!(elements.material.law, Law::LinearElastic | Law::PlaneStress);
    let is_bending = matches!(elements.cell_type, CellType::Quad4 | CellType::Hex8);
    if !is_linear || !is_bending || elements.is_ring() || !(0..elements.len()).any(&has_modes) {
        return None;
    }
    let response = Response::new(&elements.material);
    let count = elements.cell_type.node_count();
    let mut modes = Modes { slopes: Vec::new(), amplitudes: Vec::new() };
    for (cell, nodes) in elements.conn.chunks_exact(count).enumerate() {
        if !has_modes(cell) {
            modes.slopes.extend(vec![[[0.0; D]; D]; elements.points_per_cell]);
            modes.amplitudes.extend(vec![0.0; D * D * count * D]);
            continue;
        }
        let slopes = slopes(elements.cell_type, nodes, coords);
        modes.amplitudes.extend(amplitudes(elements, &response, cell, &slopes));
        modes.slopes.extend(slopes);
    }
    Some(modes)
}

/// g_m at the Gauss points of a cell.
fn slopes<const D: usize>(cell_type: CellType, nodes: &[u32], coords: &[[f64; D]]) -> Vec<[[f64; D]; D]> {
    let points = gauss_points(cell_type);
    let jacobian = |derivative: &[[f64; 3]]| -> Tensor<D> {
        from_fn(|i, j| nodes.iter().zip(derivative).map(|(&node, d)| coords[node as usize][i] * d[j]).sum())
    };
    let all: Vec<Tensor<D>> = points.iter().map(|point| jacobian(&point.derivative)).collect();
    // Slopes of shape functions at the centre are the means of those at the Gauss points.
    let mean: Tensor<D> = from_fn(|i, j| all.iter().map(|jacobian| jacobian[i][j]).sum::<f64>() / all.len() as f64);
    let (centre, inverse) = inverse_transposed(&mean);
    let at = |(jacobian, corner): (&Tensor<D>, &[f64; 3])| {
        let scale = centre / inverse_transposed(jacobian).0;
        from_fn(|mode, axis| scale * inverse[axis][mode] * -2.0 * corner[mode] / 3f64.sqrt())
    };
    all.iter().zip(&CORNERS).map(at).collect()
}

/// A of a cell: −(∫ g·C·g dV)⁻¹ ∫ g·C·∇N dV.
fn amplitudes<const D: usize>(
    elements: &Elements<D>,
    response: &Response,
    cell: usize,
    slopes: &[[[f64; D]; D]],
) -> Vec<f64> {
    let count = elements.cell_type.node_count();
    let (size, mode_count) = (count * D, D * D);
    let (mut own, mut mixed) = (DMatrix::<f64>::zeros(mode_count, mode_count), DMatrix::<f64>::zeros(mode_count, size));
    for (place, slopes) in slopes.iter().enumerate() {
        let point = cell * elements.points_per_cell + place;
        let along = |axis: usize, slope: &[f64; D]| -> Tensor<D> {
            let mut h = [[0.0; D]; D];
            h[axis] = *slope;
            h
        };
        for row in 0..mode_count {
            let h = along(row % D, &slopes[row / D]);
            let stress = response.stress_derivative(&h, &h).map(|row| row.map(|p| p * elements.volumes[point]));
            for column in 0..mode_count {
                own[(row, column)] += contract(&stress, &along(column % D, &slopes[column / D]));
            }
            for column in 0..size {
                let gradient = &elements.gradients[point * count + column / D];
                mixed[(row, column)] += contract(&stress, &along(column % D, gradient));
            }
        }
    }
    // Modes have energy, each by itself: a cell of positive volume has factors.
    let solved = own.cholesky().map_or_else(|| DMatrix::zeros(mode_count, size), |factors| factors.solve(&mixed));
    (0..mode_count).flat_map(|row| (0..size).map(move |column| (row, column))).map(|place| -solved[place]).collect()
}
