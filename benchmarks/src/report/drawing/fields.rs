//! Bodies as a run left them.

use anyhow::{Result, ensure};
use fmc_contact::CellType;
use fmc_mesh_io::{self as mesh, Mesh};
use std::path::Path;

/// A cell and its value.
pub(crate) struct Cell {
    /// What it is.
    pub cell_type: CellType,
    /// Its nodes.
    pub nodes: Vec<u32>,
    /// Von Mises stress, Pa.
    pub value: f64,
}

/// Deformed bodies with their stress.
pub(crate) struct Fields {
    /// Nodes where they are now, m.
    pub points: Vec<[f64; 3]>,
    /// Cells of all bodies.
    pub cells: Vec<Cell>,
    /// Nodes on which contact acts, with more than a millionth of the largest force.
    pub touched: Vec<usize>,
}

/// Part of the largest nodal force below which a force is rounding.
const LEAST_FORCE: f64 = 1e-6;

/// A cell of second order as it is drawn: in the plane the polygon of its corners and the middles between them, in space its corners.
fn drawn(cell_type: CellType, nodes: &[u32]) -> (CellType, Vec<u32>) {
    let straight = cell_type.straight();
    let (corners, middles) = nodes.split_at(straight.node_count());
    let outline = match cell_type.dimension() {
        2 if straight != cell_type => {
            corners.iter().zip(middles).flat_map(|(&corner, &middle)| [corner, middle]).collect()
        }
        _ => corners.to_vec(),
    };
    (straight, outline)
}

impl Fields {
    /// Reads `displacement`, `von_mises` and `contact_force` of a VTU file.
    ///
    /// # Errors
    /// If the file cannot be read or lacks one of them.
    pub(crate) fn read(path: &Path) -> Result<Self> {
        let mesh = Mesh::read(path)?;
        let displacement = mesh::read_floats(path, "displacement")?;
        let values = mesh::read_floats(path, "von_mises")?;
        let forces = mesh::read_floats(path, "contact_force")?;
        let fits = displacement.len() == 3 * mesh.points.len() && values.len() == mesh.cell_count();
        ensure!(fits && forces.len() == displacement.len(), "{} has fields of another size", path.display());
        let moved = mesh.points.iter().zip(displacement.chunks_exact(3));
        let points = moved.map(|(x, u)| std::array::from_fn(|axis| x[axis] + u[axis])).collect();
        let cells = mesh.cells().map(|(cell_type, nodes, tag, _)| {
            let value = values[tag as usize]; // the number of a cell in a VTU file is its place there
            let (cell_type, nodes) = drawn(cell_type, nodes);
            Cell { cell_type, nodes, value }
        });
        let sizes: Vec<f64> = forces.chunks_exact(3).map(|f| f.iter().map(|x| x * x).sum::<f64>().sqrt()).collect();
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        let touched = (0..sizes.len()).filter(|&node| sizes[node] > LEAST_FORCE * largest).collect();
        Ok(Self { cells: cells.collect(), points, touched })
    }

    /// Rectangle in the plane around the nodes in contact, half as wide again on each side and square; `None` if contact
    /// is none, or not small beside the bodies.
    pub(crate) fn detail(&self) -> Option<[[f64; 2]; 2]> {
        let around = |nodes: &mut dyn Iterator<Item = usize>| {
            let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
            for node in nodes {
                low = [0, 1].map(|axis| low[axis].min(self.points[node][axis]));
                high = [0, 1].map(|axis| high[axis].max(self.points[node][axis]));
            }
            ([0, 1].map(|axis| 0.5 * (low[axis] + high[axis])), (high[0] - low[0]).max(high[1] - low[1]))
        };
        let (center, contact) = around(&mut self.touched.iter().copied());
        let (_, whole) = around(&mut (0..self.points.len()));
        let half = 1.2 * contact;
        (contact > 0.0 && contact < 0.3 * whole).then(|| [center.map(|x| x - half), center.map(|x| x + half)])
    }
}
