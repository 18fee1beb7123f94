//! Bodies as they are given.

use super::Material;
use fmc_contact::CellType;
use fmc_shapes::Mesh;

/// One body: a mesh of cells of one type, of one material, undeformed. [`Model::with_cells`](super::Model::with_cells) adds cells of other types.
#[derive(Clone, Debug, PartialEq)]
pub struct Part<const D: usize> {
    /// What messages and results call it.
    pub name: String,
    /// Type of its cells.
    pub cell_type: CellType,
    /// Nodes and cells; cells have a positive Jacobian.
    pub mesh: Mesh<D>,
    /// What it is made of.
    pub material: Material,
}
