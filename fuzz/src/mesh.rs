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

impl<'a> Arbitrary<'a> for Mesh {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let dim = if bytes.arbitrary::<bool>()? { 3 } else { 2 };
        let cells: &[Cell] = if dim == 2 { &PLANE } else { &SOLID };
        let mut mesh = Mesh { dim, coords: Vec::new(), blocks: Vec::new(), ids: None };
        let any_connectivity = bytes.arbitrary::<u8>()? < 24;
        let body_count = 1 + bytes.arbitrary::<u8>()? as usize % 3;
        for _ in 0..body_count {
            let (cell_type, corners) = cells[bytes.arbitrary::<u8>()? as usize % cells.len()];
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
