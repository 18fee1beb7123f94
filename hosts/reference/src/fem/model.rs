//! Parts in one node numbering.

use super::elements::Elements;
use super::{Error, Part};
use fmc_contact::{Bodies, CellBlock, CellType, Surface};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::ops::Range;

/// Further cells of a part, of another type and on its nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct Cells {
    /// The part.
    pub part: usize,
    /// Type of the cells.
    pub cell_type: CellType,
    /// Node ids of the part's mesh, `[cell_count, node_count]`; cells have a positive Jacobian.
    pub conn: Vec<u32>,
}

/// All bodies of a problem: their nodes one after another, part after part, each with the elements of its cells.
#[derive(Debug)]
pub struct Model<const D: usize> {
    parts: Vec<Part<D>>,
    pub(super) coords: Vec<[f64; D]>,
    /// First node of every part, and the number of nodes.
    first_nodes: Vec<usize>,
    /// First elements of every part, one for each type of its cells, and the number of all.
    first_elements: Vec<usize>,
    pub(super) elements: Vec<Elements<D>>,
    pub(super) pool: Option<ThreadPool>,
}

impl<const D: usize> Model<D> {
    /// Model of the parts, on one thread.
    ///
    /// # Errors
    /// Those of [`Model::with_cells`].
    pub fn new(parts: Vec<Part<D>>) -> Result<Self, Error> {
        Self::with_cells(parts, &[])
    }

    /// Bodies of revolution about r = 0, whose sections are the parts, in coordinates (r, z): energies, forces and masses are of whole rings.
    ///
    /// # Errors
    /// Those of [`Model::with_cells`]; [`Error::InvertedCell`] for cells across the axis, too.
    pub fn axisymmetric(parts: Vec<Part<D>>, more: &[Cells]) -> Result<Self, Error> {
        Self::of(parts, more, true)
    }

    /// The same with further cells, of parts whose cells are of several types.
    ///
    /// # Errors
    /// [`Error::Empty`], [`Error::CellType`], [`Error::NoElement`], [`Error::NodeOutOfRange`], [`Error::UnusedNode`],
    /// [`Error::NonFiniteCoordinate`], [`Error::InvertedCell`], [`Error::Material`].
    pub fn with_cells(parts: Vec<Part<D>>, more: &[Cells]) -> Result<Self, Error> {
        Self::of(parts, more, false)
    }

    fn of(parts: Vec<Part<D>>, more: &[Cells], is_ring: bool) -> Result<Self, Error> {
        if parts.is_empty() || more.iter().any(|cells| cells.part >= parts.len()) {
            return Err(Error::Empty);
        }
        let mut coords = Vec::new();
        let (mut first_nodes, mut first_elements) = (vec![0], vec![0]);
        let mut elements = Vec::new();
        for (number, part) in parts.iter().enumerate() {
            let more: Vec<&Cells> = more.iter().filter(|cells| cells.part == number).collect();
            elements.extend(Elements::of_part(part, &more, (coords.len(), is_ring && D == 2))?);
            first_elements.push(elements.len());
            coords.extend_from_slice(&part.mesh.coords);
            first_nodes.push(coords.len());
        }
        Ok(Self { parts, coords, first_nodes, first_elements, elements, pool: None })
    }

    /// The same on `threads` threads; results do not depend on them.
    ///
    /// # Errors
    /// [`Error::Threads`].
    pub fn with_threads(mut self, threads: usize) -> Result<Self, Error> {
        self.pool = match threads {
            0 => return Err(Error::Threads { threads }),
            1 => None,
            _ => Some(ThreadPoolBuilder::new().num_threads(threads).build().map_err(|_| Error::Threads { threads })?),
        };
        Ok(self)
    }

    /// The parts, in the order given.
    pub fn parts(&self) -> &[Part<D>] {
        &self.parts
    }

    /// Whether they are bodies of revolution, and coordinates (r, z).
    pub fn is_axisymmetric(&self) -> bool {
        self.elements.iter().any(Elements::is_ring)
    }

    /// Node coordinates of the undeformed bodies, `[node_count, D]`.
    pub fn coords(&self) -> &[[f64; D]] {
        &self.coords
    }

    /// Number of nodes of all parts.
    pub fn node_count(&self) -> usize {
        self.coords.len()
    }

    /// Nodes of a part.
    pub fn nodes_of(&self, part: usize) -> Range<usize> {
        self.first_nodes[part]..self.first_nodes[part + 1]
    }

    /// Nodes of a part whose undeformed place fulfils the condition.
    pub fn nodes_where(&self, part: usize, condition: impl Fn(&[f64; D]) -> bool) -> Vec<usize> {
        self.nodes_of(part).filter(|&node| condition(&self.coords[node])).collect()
    }

    /// Number of cells of all parts.
    pub fn cell_count(&self) -> usize {
        self.elements.iter().map(Elements::len).sum()
    }

    /// The elements of a part, by the types of its cells.
    pub(super) fn elements_of(&self, part: usize) -> &[Elements<D>] {
        &self.elements[self.first_elements[part]..self.first_elements[part + 1]]
    }

    /// Cells of a part, each with its type and its nodes in the numbering of the model.
    pub fn cells(&self, part: usize) -> impl Iterator<Item = (CellType, &[u32])> {
        self.elements_of(part).iter().flat_map(|elements| {
            let (cell_type, conn) = (elements.cell_type, elements.conn.as_slice());
            conn.chunks_exact(cell_type.node_count()).map(move |nodes| (cell_type, nodes))
        })
    }

    /// Boundary of all parts for the contact module; body ids are the indices of the parts.
    ///
    /// # Errors
    /// Those of [`Surface::from_cells`].
    pub fn surface(&self) -> Result<Surface<D>, fmc_contact::Error> {
        let blocks: Vec<CellBlock> =
            self.elements.iter().map(|e| CellBlock { cell_type: e.cell_type, conn: &e.conn }).collect();
        let ids: Vec<i64> = (0..self.parts.len())
            .flat_map(|part| std::iter::repeat_n(part as i64, self.elements_of(part).iter().map(Elements::len).sum()))
            .collect();
        Surface::from_cells(&self.coords, &blocks, Bodies::Ids(&ids))
    }
}
