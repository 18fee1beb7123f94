//! What can be wrong with a model.

use fmc_contact::CellType;
use std::fmt;

/// Why a model cannot be built. Parts are named, cells and nodes counted from 0 inside their part.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// There is no part, or a part without cells.
    Empty,
    /// Cells of this type do not fill the space of the model, or have another number of nodes.
    CellType {
        /// Name of the part.
        part: String,
        /// Type of its cells.
        cell_type: CellType,
        /// Dimension of the model.
        dimension: usize,
        /// Nodes that the mesh has per cell.
        nodes_per_cell: usize,
    },
    /// There are no finite elements of this type here.
    NoElement {
        /// Name of the part.
        part: String,
        /// Type of its cells.
        cell_type: CellType,
    },
    /// A cell names a node that the part does not have.
    NodeOutOfRange {
        /// Name of the part.
        part: String,
        /// The cell.
        cell: usize,
        /// The node it names.
        node: u32,
        /// Nodes of the part.
        node_count: usize,
    },
    /// No cell uses the node: it would have no mass.
    UnusedNode {
        /// Name of the part.
        part: String,
        /// The node.
        node: usize,
    },
    /// A part in space has plane stress.
    PlaneStress {
        /// Name of the part.
        part: String,
    },
    /// A coordinate is infinite or not a number.
    NonFiniteCoordinate {
        /// Name of the part.
        part: String,
        /// The node.
        node: usize,
    },
    /// The Jacobian of a cell is not positive at one of its Gauss points.
    InvertedCell {
        /// Name of the part.
        part: String,
        /// The cell.
        cell: usize,
    },
    /// A material constant out of its range.
    Material {
        /// Name of the part.
        part: String,
        /// The constant.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it has to be.
        range: &'static str,
    },
    /// Threads cannot be started.
    Threads {
        /// Number asked for.
        threads: usize,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Empty => write!(f, "a model needs parts with cells"),
            Error::CellType { part, cell_type, dimension, nodes_per_cell } => {
                write!(f, "{part}: {cell_type:?} with {nodes_per_cell} nodes per cell in a {dimension}D model")
            }
            Error::PlaneStress { part } => write!(f, "{part}: plane stress is known in the plane alone"),
            Error::NoElement { part, cell_type } => {
                write!(
                    f,
                    "{part}: there are no elements of {cell_type:?}, only of triangles, quadrilaterals, tetrahedra, wedges and hexahedra"
                )
            }
            Error::NodeOutOfRange { part, cell, node, node_count } => {
                write!(f, "{part}: cell {cell} names node {node}, but there are {node_count} nodes")
            }
            Error::UnusedNode { part, node } => write!(f, "{part}: node {node} belongs to no cell"),
            Error::NonFiniteCoordinate { part, node } => write!(f, "{part}: node {node} is not at a finite place"),
            Error::InvertedCell { part, cell } => write!(f, "{part}: cell {cell} is inverted or has no volume"),
            Error::Material { part, name, value, range } => write!(f, "{part}: {name} = {value} is not {range}"),
            Error::Threads { threads } => write!(f, "{threads} threads cannot be started"),
        }
    }
}

impl std::error::Error for Error {}
