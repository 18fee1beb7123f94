//! Elements of one part: what of the reference configuration their integrals need.

use super::quadrature::gauss_points;
use super::{Error, Material, Part};
use fmc_contact::CellType;
use nalgebra::SMatrix;

/// Elements of one part in flat arrays; node ids are those of the model.
#[derive(Debug)]
pub(super) struct Elements<const D: usize> {
    pub(super) cell_type: CellType,
    pub(super) material: Material,
    /// `[cell_count, node_count]`.
    pub(super) conn: Vec<u32>,
    /// Gradients ∇N_a by the reference place, `[cell_count, point_count, node_count]`.
    pub(super) gradients: Vec<[f64; D]>,
    /// Volume that each Gauss point stands for, `[cell_count, point_count]`.
    pub(super) volumes: Vec<f64>,
    /// ∫ N_a dV, `[cell_count, node_count]`.
    pub(super) shares: Vec<f64>,
}

impl<const D: usize> Elements<D> {
    /// Elements of a part whose first node is `first_node` of the model.
    pub(super) fn new(part: &Part<D>, first_node: u32) -> Result<Self, Error> {
        check(part)?;
        let points = gauss_points(part.cell_type);
        let coords = &part.mesh.coords;
        let (mut gradients, mut volumes, mut shares) = (Vec::new(), Vec::new(), Vec::new());
        for (cell, nodes) in part.mesh.cells().enumerate() {
            let mut share = vec![0.0; nodes.len()];
            for point in &points {
                // J = ∂X/∂ξ; ∇N = J^(−T) ∂N/∂ξ.
                let mut jacobian = SMatrix::<f64, D, D>::zeros();
                for (&node, derivative) in nodes.iter().zip(&point.derivative) {
                    for i in 0..D {
                        (0..D).for_each(|j| jacobian[(i, j)] += coords[node as usize][i] * derivative[j]);
                    }
                }
                let (determinant, inverse) = inverse(jacobian);
                let volume = point.weight * determinant;
                if volume.is_nan() || volume <= 0.0 {
                    return Err(Error::InvertedCell { part: part.name.clone(), cell });
                }
                gradients.extend(point.derivative.iter().map(|derivative| -> [f64; D] {
                    std::array::from_fn(|i| (0..D).map(|j| inverse[(j, i)] * derivative[j]).sum())
                }));
                volumes.push(volume);
                share.iter_mut().zip(&point.shape).for_each(|(share, shape)| *share += shape * volume);
            }
            shares.extend(share);
        }
        let conn = part.mesh.conn.iter().map(|node| node + first_node).collect();
        Ok(Self { cell_type: part.cell_type, material: part.material, conn, gradients, volumes, shares })
    }

    /// Number of cells.
    pub(super) fn len(&self) -> usize {
        self.conn.len() / self.cell_type.node_count()
    }

    /// Gauss points per cell.
    pub(super) fn point_count(&self) -> usize {
        self.volumes.len() / self.len()
    }
}

/// Determinant and inverse; the inverse of a singular matrix is not finite.
fn inverse<const D: usize>(m: SMatrix<f64, D, D>) -> (f64, SMatrix<f64, D, D>) {
    let cofactor = SMatrix::<f64, D, D>::from_fn(|i, j| {
        let at = |k: usize, l: usize| m[((i + k) % D, (j + l) % D)];
        match D {
            2 if i == j => at(1, 1),
            2 => -at(1, 1),
            _ => at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1),
        }
    });
    let determinant = (0..D).map(|j| m[(0, j)] * cofactor[(0, j)]).sum::<f64>();
    (determinant, cofactor.transpose() / determinant)
}

/// Whether arrays fit together and constants are in their range.
fn check<const D: usize>(part: &Part<D>) -> Result<(), Error> {
    let (name, mesh, cell_type) = (|| part.name.clone(), &part.mesh, part.cell_type);
    if mesh.nodes_per_cell != cell_type.node_count() || cell_type.dimension() != D {
        return Err(Error::CellType { part: name(), cell_type, dimension: D, nodes_per_cell: mesh.nodes_per_cell });
    }
    if mesh.conn.is_empty() {
        return Err(Error::Empty);
    }
    let node_count = mesh.coords.len();
    let mut used = vec![false; node_count];
    for (cell, nodes) in mesh.cells().enumerate() {
        for &node in nodes {
            let out_of_range = || Error::NodeOutOfRange { part: name(), cell, node, node_count };
            *used.get_mut(node as usize).ok_or_else(out_of_range)? = true;
        }
    }
    if let Some(node) = used.iter().position(|used| !used) {
        return Err(Error::UnusedNode { part: name(), node });
    }
    if let Some(node) = mesh.coords.iter().position(|x| x.iter().any(|x| !x.is_finite())) {
        return Err(Error::NonFiniteCoordinate { part: name(), node });
    }
    match part.material.flaw() {
        Some((constant, value, range)) => Err(Error::Material { part: name(), name: constant, value, range }),
        None => Ok(()),
    }
}
