//! What a rank gives of a mesh.

use crate::geometry::CellBlock;

/// The cells of one rank, with their nodes. Every cell of the mesh is given by one rank, and only by that; nodes between ranks
/// are given by all that have a cell there. A rank may have none.
#[derive(Clone, Copy, Debug)]
pub struct MeshPart<'a, const D: usize> {
    /// Coordinates of the rank's nodes without deformation.
    pub coords: &'a [[f64; D]],
    /// Number of each in the whole mesh: the same on all ranks that have it. Results are those of one rank alone whose mesh has
    /// nodes in the order of these numbers; they need not be without gaps.
    pub node_numbers: &'a [u64],
    /// Cells, of nodes of this rank.
    pub blocks: &'a [CellBlock<'a>],
    /// Number of each cell in the whole mesh, over all blocks. Results are those of a mesh with cells in the order of these.
    pub cell_numbers: &'a [u64],
    /// Body of each cell, as all ranks name it.
    pub body_ids: &'a [i64],
}
