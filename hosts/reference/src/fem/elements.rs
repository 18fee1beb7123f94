//! Elements of one type of one part: what of the reference configuration their integrals need.

use super::cofactor::cofactor;
use super::modes::Modes;
use super::quadrature::gauss_points;
use super::tensor::{Tensor, from_fn};
use super::{Cells, Error, Law, Material, Part};
use fmc_contact::CellType;

/// Elements of one type of one part in flat arrays; node ids are those of the model.
#[derive(Debug)]
pub(super) struct Elements<const D: usize> {
    pub(super) cell_type: CellType,
    pub(super) material: Material,
    /// Gauss points per cell.
    pub(super) points_per_cell: usize,
    /// First node of the part in the model.
    pub(super) first_node: usize,
    /// `[cell_count, node_count]`.
    pub(super) conn: Vec<u32>,
    /// Gradients ∇N_a by the reference place, `[cell_count, point_count, node_count]`.
    pub(super) gradients: Vec<[f64; D]>,
    /// Volume that each Gauss point stands for, `[cell_count, point_count]`.
    pub(super) volumes: Vec<f64>,
    /// N_a / r, as `gradients`, of bodies of revolution; empty of others.
    pub(super) hoops: Vec<f64>,
    /// Incompatible modes, if cells have any.
    pub(super) modes: Option<Modes<D>>,
    /// ∫ N_a dV, `[cell_count, node_count]`.
    pub(super) shares: Vec<f64>,
    /// Volume whose mass is lumped at each node, `[cell_count, node_count]`.
    pub(super) lumps: Vec<f64>,
    /// Entries of `conn` by the node that they name, each node's ascending, and where each node's begin.
    slots: Vec<u32>,
    first_slots: Vec<u32>,
}

/// One cell of `N` nodes.
pub(super) struct Cell<'a, const D: usize, const N: usize> {
    pub(super) nodes: &'a [u32; N],
    /// ∇N_a at each Gauss point.
    pub(super) gradients: &'a [[[f64; D]; N]],
    /// N_a / r at each Gauss point; none in the plane.
    pub(super) hoops: &'a [[f64; N]],
    /// Volume of each Gauss point.
    pub(super) volumes: &'a [f64],
}

impl<const D: usize> Elements<D> {
    /// Elements of a part whose first node is `first_node` of the model, one for each type of its cells: those of its mesh, then `more`;
    /// of revolution about r = 0 with `is_ring`.
    pub(super) fn of_part(
        part: &Part<D>,
        more: &[&Cells],
        (first_node, is_ring): (usize, bool),
    ) -> Result<Vec<Self>, Error> {
        let own = (part.cell_type, part.mesh.conn.as_slice());
        let blocks: Vec<(CellType, &[u32])> =
            std::iter::once(own).chain(more.iter().map(|cells| (cells.cell_type, cells.conn.as_slice()))).collect();
        check(part, &blocks)?;
        let mut first_cell = 0;
        let new = |block: (CellType, &[u32])| {
            let elements = Self::new(part, block, (first_cell, first_node), is_ring)?;
            first_cell += elements.len();
            Ok(elements)
        };
        blocks.into_iter().map(new).collect()
    }

    fn new(
        part: &Part<D>,
        (cell_type, conn): (CellType, &[u32]),
        (first_cell, first_node): (usize, usize),
        is_ring: bool,
    ) -> Result<Self, Error> {
        let points = gauss_points(cell_type);
        let coords = &part.mesh.coords;
        let (mut gradients, mut volumes, mut hoops) = (Vec::new(), Vec::new(), Vec::new());
        let (mut shares, mut lumps) = (Vec::new(), Vec::new());
        for (cell, nodes) in (first_cell..).zip(conn.chunks_exact(cell_type.node_count())) {
            let mut share = vec![0.0; nodes.len()];
            let mut square = share.clone();
            for point in &points {
                // J = ∂X/∂ξ; ∇N = J^(−T) ∂N/∂ξ.
                let jacobian: Tensor<D> = from_fn(|i, j| {
                    nodes.iter().zip(&point.derivative).map(|(&node, d)| coords[node as usize][i] * d[j]).sum()
                });
                let (determinant, inverse) = inverse_transposed(&jacobian);
                let radius: f64 = nodes.iter().zip(&point.shape).map(|(&node, n)| n * coords[node as usize][0]).sum();
                let around = if is_ring { circumference(radius) } else { 1.0 };
                let volume = point.weight * determinant * around;
                if is_ring {
                    hoops.extend(point.shape.iter().map(|n| n / radius));
                }
                // Cells across the axis have none either.
                if determinant <= 0.0 || around <= 0.0 || volume.is_nan() || volume <= 0.0 {
                    return Err(Error::InvertedCell { part: part.name.clone(), cell });
                }
                gradients.extend(point.derivative.iter().map(|derivative| -> [f64; D] {
                    std::array::from_fn(|i| (0..D).map(|j| inverse[i][j] * derivative[j]).sum())
                }));
                volumes.push(volume);
                share.iter_mut().zip(&point.shape).for_each(|(share, shape)| *share += shape * volume);
                square.iter_mut().zip(&point.shape).for_each(|(square, shape)| *square += shape * shape * volume);
            }
            lumps.extend(lumped(cell_type, &share, &square));
            shares.extend(share);
        }
        let (slots, first_slots) = slots_by_node(conn, coords.len());
        let conn = conn.iter().map(|node| node + first_node as u32).collect();
        Ok(Self {
            cell_type,
            material: part.material,
            points_per_cell: points.len(),
            first_node,
            conn,
            gradients,
            volumes,
            hoops,
            modes: None,
            shares,
            lumps,
            slots,
            first_slots,
        })
    }

    /// Whether they are of bodies of revolution.
    pub(super) fn is_ring(&self) -> bool {
        !self.hoops.is_empty()
    }

    /// Number of cells.
    pub(super) fn len(&self) -> usize {
        self.conn.len() / self.cell_type.node_count()
    }

    /// Number of nodes of the part.
    pub(super) fn node_count(&self) -> usize {
        self.first_slots.len() - 1
    }

    /// Entries of `conn` that name the part's node `node`, counted from 0 in the part.
    pub(super) fn slots_of(&self, node: usize) -> &[u32] {
        &self.slots[self.first_slots[node] as usize..self.first_slots[node + 1] as usize]
    }

    /// One cell, of `N` nodes.
    #[inline(always)]
    pub(super) fn cell<const N: usize>(&self, cell: usize) -> Cell<'_, D, N> {
        let count = self.points_per_cell;
        Cell {
            nodes: &self.conn.as_chunks::<N>().0[cell],
            gradients: &self.gradients.as_chunks::<N>().0[cell * count..][..count],
            hoops: if self.is_ring() { &self.hoops.as_chunks::<N>().0[cell * count..][..count] } else { &[] },
            volumes: &self.volumes[cell * count..][..count],
        }
    }
}

/// Circumference at a radius.
pub(super) fn circumference(radius: f64) -> f64 {
    2.0 * std::f64::consts::PI * radius
}

/// Entries of `conn` sorted by node, and where each node's begin.
fn slots_by_node(conn: &[u32], node_count: usize) -> (Vec<u32>, Vec<u32>) {
    let mut first = vec![0u32; node_count + 1];
    conn.iter().for_each(|&node| first[node as usize + 1] += 1);
    (0..node_count).for_each(|node| first[node + 1] += first[node]);
    let mut next = first.clone();
    let mut slots = vec![0; conn.len()];
    for (slot, &node) in conn.iter().enumerate() {
        slots[next[node as usize] as usize] = slot as u32;
        next[node as usize] += 1;
    }
    (slots, first)
}

/// Parts of a cell's volume at its nodes, from ∫ N_a dV and ∫ N_a² dV: the former on cells of first order; of second order, where
/// those of corners vanish or are negative, the volume in proportion to the latter (Hinton, Rock and Zienkiewicz, "A note
/// on mass lumping and related processes in the finite element method").
fn lumped(cell_type: CellType, share: &[f64], square: &[f64]) -> Vec<f64> {
    if cell_type == cell_type.straight() {
        return share.to_vec();
    }
    let (volume, squares): (f64, f64) = (share.iter().sum(), square.iter().sum());
    square.iter().map(|square| volume * square / squares).collect()
}

/// Determinant and transposed inverse; the inverse of a singular matrix is not finite.
pub(super) fn inverse_transposed<const D: usize>(m: &Tensor<D>) -> (f64, Tensor<D>) {
    let cofactor = cofactor(m);
    let determinant: f64 = (0..D).map(|j| m[0][j] * cofactor[0][j]).sum();
    (determinant, cofactor.map(|row| row.map(|entry| entry / determinant)))
}

/// Whether arrays fit together and constants are in their range.
fn check<const D: usize>(part: &Part<D>, blocks: &[(CellType, &[u32])]) -> Result<(), Error> {
    let (name, mesh) = (|| part.name.clone(), &part.mesh);
    let node_count = mesh.coords.len();
    let mut used = vec![false; node_count];
    let mut first_cell = 0;
    for (number, &(cell_type, conn)) in blocks.iter().enumerate() {
        use CellType::{Hex8, Quad4, Tet4, Tri3, Wedge6};
        let has_elements = matches!(cell_type.straight(), Tri3 | Quad4 | Tet4 | Hex8 | Wedge6);
        if !has_elements {
            return Err(Error::NoElement { part: name(), cell_type });
        }
        let nodes_per_cell = if number == 0 { mesh.nodes_per_cell } else { cell_type.node_count() };
        let is_whole = conn.len() % cell_type.node_count() == 0;
        if nodes_per_cell != cell_type.node_count() || cell_type.dimension() != D || !is_whole {
            return Err(Error::CellType { part: name(), cell_type, dimension: D, nodes_per_cell });
        }
        if conn.is_empty() {
            return Err(Error::Empty);
        }
        for (cell, nodes) in (first_cell..).zip(conn.chunks_exact(nodes_per_cell)) {
            for &node in nodes {
                let out_of_range = || Error::NodeOutOfRange { part: name(), cell, node, node_count };
                *used.get_mut(node as usize).ok_or_else(out_of_range)? = true;
            }
        }
        first_cell += conn.len() / nodes_per_cell;
    }
    if let Some(node) = used.iter().position(|used| !used) {
        return Err(Error::UnusedNode { part: name(), node });
    }
    if let Some(node) = mesh.coords.iter().position(|x| x.iter().any(|x| !x.is_finite())) {
        return Err(Error::NonFiniteCoordinate { part: name(), node });
    }
    if D == 3 && part.material.law == Law::PlaneStress {
        return Err(Error::PlaneStress { part: name() });
    }
    match part.material.flaw() {
        Some((constant, value, range)) => Err(Error::Material { part: name(), name: constant, value, range }),
        None => Ok(()),
    }
}
