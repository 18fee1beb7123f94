//! Small meshes: cells that are sound, moved about, so that most of them meet; and connectivity of any kind.

use crate::number::Number;
use arbitrary::{Arbitrary, Result, Unstructured};

/// Cells of one or more types on one node array.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// 2 or 3.
    pub dim: usize,
    /// Rows of `dim`.
    pub coords: Vec<f64>,
    /// Type by its VTK number, and nodes.
    pub blocks: Vec<(i32, Vec<i64>)>,
    /// Body of every cell, where given.
    pub ids: Option<Vec<i64>>,
}

/// VTK number and corners of the unit cell.
type Cell = (i32, &'static [[f64; 3]]);

const PLANE: [Cell; 2] =
    [(5, &[[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]]), (9, &[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]])];
const SOLID: [Cell; 4] = [
    (10, &[[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]]),
    (
        12,
        &[
            [0., 0., 0.],
            [1., 0., 0.],
            [1., 1., 0.],
            [0., 1., 0.],
            [0., 0., 1.],
            [1., 0., 1.],
            [1., 1., 1.],
            [0., 1., 1.],
        ],
    ),
    (13, &[[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.], [1., 0., 1.], [0., 1., 1.]]),
    (14, &[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.], [0.5, 0.5, 1.]]),
];

/// The cell of second order with these corners, or with `full` nodes in the middles of quadrilaterals too: VTK number and the
/// corners whose mean is a node.
fn second_order(straight: i32, full: bool) -> (i32, Vec<&'static [usize]>) {
    const TRIANGLE: &[&[usize]] = &[&[0, 1], &[1, 2], &[2, 0]];
    const QUAD: &[&[usize]] = &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]];
    const TET: &[&[usize]] = &[&[0, 3], &[1, 3], &[2, 3]];
    const HEX: &[&[usize]] = &[&[4, 5], &[5, 6], &[6, 7], &[7, 4], &[0, 4], &[1, 5], &[2, 6], &[3, 7]];
    const HEX_FACES: &[&[usize]] =
        &[&[0, 4, 7, 3], &[1, 2, 6, 5], &[0, 1, 5, 4], &[3, 7, 6, 2], &[0, 3, 2, 1], &[4, 5, 6, 7]];
    match (straight, full) {
        (5, _) => (22, TRIANGLE.to_vec()),
        (9, false) => (23, QUAD.to_vec()),
        (9, true) => (28, [QUAD, &[&[0, 1, 2, 3]]].concat()),
        (10, _) => (24, [TRIANGLE, TET].concat()),
        (12, false) => (25, [QUAD, HEX].concat()),
        (12, true) => (29, [QUAD, HEX, HEX_FACES, &[&[0, 1, 2, 3, 4, 5, 6, 7]]].concat()),
        (13, _) => (26, [TRIANGLE, &[&[3, 4], &[4, 5], &[5, 3], &[0, 3], &[1, 4], &[2, 5]]].concat()),
        _ => (27, [QUAD, &[&[0, 4], &[1, 4], &[2, 4], &[3, 4]]].concat()),
    }
}

impl<'a> Arbitrary<'a> for Mesh {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let dim = if bytes.arbitrary::<bool>()? { 3 } else { 2 };
        let cells: &[Cell] = if dim == 2 { &PLANE } else { &SOLID };
        let mut mesh = Mesh { dim, coords: Vec::new(), blocks: Vec::new(), ids: None };
        let any_connectivity = bytes.arbitrary::<u8>()? < 24;
        let how = bytes.arbitrary::<u8>()? as usize;
        let (body_count, is_curved, is_torn) = (1 + how % 3, how / 3 % 4 == 3, how / 12 % 4 == 3);
        for _ in 0..body_count {
            let kind = bytes.arbitrary::<u8>()? as usize;
            let (mut cell_type, corners) = cells[kind % cells.len()];
            let first = (mesh.coords.len() / dim) as i64;
            let mut conn: Vec<i64> = (first..first + corners.len() as i64).collect();
            let place: [Number; 3] = bytes.arbitrary()?;
            let is_bent = bytes.arbitrary::<bool>()?;
            for corner in corners {
                for axis in 0..dim {
                    let bend = if is_bent { bytes.arbitrary::<Number>()?.0 / 16.0 } else { 0.0 };
                    mesh.coords.push(place[axis].0 + corner[axis] + bend);
                }
            }
            if is_curved && (!is_torn || kind / cells.len() % 3 > 0) {
                let at = mesh.coords[mesh.coords.len() - corners.len() * dim..].to_vec();
                let (of_second_order, middles) = second_order(cell_type, kind / cells.len() % 2 == 1);
                cell_type = of_second_order;
                for around in middles {
                    conn.push((mesh.coords.len() / dim) as i64);
                    for axis in 0..dim {
                        let bend = if is_bent { bytes.arbitrary::<Number>()?.0 / 64.0 } else { 0.0 };
                        let sum = around.iter().map(|corner| at[corner * dim + axis]).sum::<f64>();
                        mesh.coords.push(sum / around.len() as f64 + bend);
                    }
                }
            }
            if is_torn && first > 0 {
                // Some nodes of an earlier cell, in whose middles there are others.
                for node in conn.iter_mut().take(1 + kind % 8) {
                    *node = (*node - first).min(first - 1);
                }
            }
            if any_connectivity {
                for node in &mut conn {
                    *node = i64::from(bytes.arbitrary::<u8>()? % 40) - 1;
                }
            }
            match mesh.blocks.last_mut() {
                Some((last, nodes)) if *last == cell_type => nodes.extend(conn),
                _ => mesh.blocks.push((cell_type, conn)),
            }
        }
        if bytes.arbitrary::<bool>()? {
            let ids = (0..body_count).map(|_| Ok(i64::from(bytes.arbitrary::<u8>()? % 3)));
            mesh.ids = Some(ids.collect::<Result<_>>()?);
        }
        Ok(mesh)
    }
}

impl Mesh {
    /// Number of nodes.
    pub fn node_count(&self) -> usize {
        self.coords.len() / self.dim
    }

    /// Whether lines across all bodies are few, at spacings that are not small.
    pub fn is_ordinary(&self) -> bool {
        self.coords.iter().all(|x| Number(*x).is_ordinary())
    }
}
