//! How large a case is, before anything of that size is made.

use super::{Case, MeshSource};
use std::f64::consts::{FRAC_PI_2, SQRT_2, TAU};

/// Nodes of a body, at most: what a host that holds a whole mesh in one process can solve ends far below.
pub const MOST_NODES: f64 = 1e7;

/// Steps in time, at most: a line of the history each, all of which are held until the end.
pub const MOST_STEPS: f64 = 1e7;

/// Load steps of a stage, at most.
pub const MOST_LOAD_STEPS: usize = 100_000;

impl Case {
    /// Nodes of all bodies that are generated, estimated from above; those of files are not counted.
    pub fn node_estimate(&self) -> f64 {
        self.bodies.iter().map(|body| body.mesh.node_estimate()).sum()
    }
}

impl MeshSource {
    /// Nodes that a generator makes: right within a factor of some units, never far too few. Infinite or NaN for numbers of which no
    /// mesh can be made, 0 for a file.
    pub fn node_estimate(&self) -> f64 {
        let lattice = |cells: &[usize]| cells.iter().map(|&n| n as f64 + 1.0).product::<f64>();
        let of_first_order = match self {
            MeshSource::Rectangle { cells, .. } | MeshSource::Quadrilateral { cells, .. } => lattice(cells),
            MeshSource::Quadrilaterals { parts, .. } => parts.iter().map(|part| lattice(&part.cells)).sum(),
            &MeshSource::Star { tips, side_edges, half_width, .. } => {
                tips as f64 * (2.0 * half_width as f64 + 1.0) * (side_edges as f64 + 1.0)
            }
            &MeshSource::Disc { edges, .. } => (edges as f64 + 1.0) * (edges as f64 / TAU + 2.0),
            &MeshSource::GradedHalfDisc { radius, finest, fine_to, growth, .. } => {
                // ∫ π r dr / h² over the rings about the tip, h = finest + growth (r − fine_to); r at most √2 R beyond fine_to.
                let beyond = SQRT_2 * radius - fine_to;
                let inside = FRAC_PI_2 * (fine_to / finest).powi(2);
                inside + 2.0 * FRAC_PI_2 * SQRT_2 * radius * beyond / (finest * (finest + growth * beyond))
            }
            MeshSource::Cuboid { cells, .. } => lattice(cells),
            &MeshSource::Tetrahedron { edges, .. } => (edges as f64 + 3.0).powi(3) / 6.0,
            &MeshSource::Ball { level, layers, .. } => 10.4 * 4f64.powf(level as f64) * layers as f64,
            MeshSource::GradedBlock { size, cells, shells, .. } => {
                let (side, axes) = (*cells as f64 + 1.0, size.len() as f64);
                side.powf(axes) + axes * *shells as f64 * side.powf(axes - 1.0)
            }
            &MeshSource::GradedHalfBall { radius, finest, edges, .. } => {
                let shells = (SQRT_2 * radius / finest).ln() / (FRAC_PI_2 / edges as f64).ln_1p();
                (shells + 2.0) * (edges as f64 + 2.0).powi(2) / 2.0
            }
            MeshSource::File { .. } => 0.0,
        };
        let is_raised = self.cell().is_some_and(|cell| cell != cell.straight());
        let per_node = if is_raised { 2f64.powi(self.dimension().unwrap_or(3) as i32) } else { 1.0 };
        of_first_order * per_node
    }
}
