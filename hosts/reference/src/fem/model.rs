//! Parts in one node numbering.

use super::elements::Elements;
use super::{Error, Part};
use fmc_contact::{Bodies, CellBlock, Surface};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::ops::Range;

/// All bodies of a problem: their nodes one after another, part after part, each with the elements of its cells.
#[derive(Debug)]
pub struct Model<const D: usize> {
    parts: Vec<Part<D>>,
    coords: Vec<[f64; D]>,
    /// First node of every part, and the number of nodes.
    first_nodes: Vec<usize>,
    pub(super) elements: Vec<Elements<D>>,
    pub(super) pool: Option<ThreadPool>,
}

impl<const D: usize> Model<D> {
    /// Model of the parts, on one thread.
    ///
    /// # Errors
    /// [`Error::Empty`], [`Error::CellType`], [`Error::NoElement`], [`Error::NodeOutOfRange`], [`Error::UnusedNode`],
    /// [`Error::NonFiniteCoordinate`], [`Error::InvertedCell`], [`Error::Material`].
    pub fn new(parts: Vec<Part<D>>) -> Result<Self, Error> {
        if parts.is_empty() {
            return Err(Error::Empty);
        }
        let mut coords = Vec::new();
        let mut first_nodes = vec![0];
        let mut elements = Vec::new();
        for part in &parts {
            elements.push(Elements::new(part, coords.len())?);
            coords.extend_from_slice(&part.mesh.coords);
            first_nodes.push(coords.len());
        }
        Ok(Self { parts, coords, first_nodes, elements, pool: None })
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

    /// Node ids of the cells of a part, cell after cell, in the numbering of the model.
    pub fn conn(&self, part: usize) -> &[u32] {
        &self.elements[part].conn
    }

    /// Boundary of all parts for the contact module; body ids are the indices of the parts.
    ///
    /// # Errors
    /// Those of [`Surface::from_cells`].
    pub fn surface(&self) -> Result<Surface<D>, fmc_contact::Error> {
        let blocks: Vec<CellBlock> = self
            .parts
            .iter()
            .zip(&self.elements)
            .map(|(part, e)| CellBlock { cell_type: part.cell_type, conn: &e.conn })
            .collect();
        let ids: Vec<i64> =
            self.elements.iter().enumerate().flat_map(|(part, e)| std::iter::repeat_n(part as i64, e.len())).collect();
        Surface::from_cells(&self.coords, &blocks, Bodies::Ids(&ids))
    }
}
