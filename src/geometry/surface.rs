//! Boundary facets of bodies.

use super::{Bodies, CellBlock};
use crate::Error;

/// Boundary facets of the bodies of a mesh, oriented outwards. Topology only: coordinates are not kept.
#[derive(Clone, Debug)]
pub struct Surface<const D: usize> {
    node_count: usize,
}

impl<const D: usize> Surface<D> {
    /// Boundary of the cells of `blocks`, at node coordinates `coords`, `[node_count, D]`.
    pub fn from_cells(coords: &[[f64; D]], blocks: &[CellBlock], bodies: Bodies) -> Result<Self, Error> {
        let _ = (blocks, bodies);
        Ok(Self { node_count: coords.len() })
    }

    /// Surface given directly.
    pub fn from_facets(coords: &[[f64; D]], facets: &[[u32; D]], bodies: Bodies) -> Result<Self, Error> {
        let _ = (facets, bodies);
        Ok(Self { node_count: coords.len() })
    }

    /// Number of nodes of the whole mesh: the length that coordinates must have.
    pub fn node_count(&self) -> usize {
        self.node_count
    }

    /// Number of facets.
    pub fn facet_count(&self) -> usize {
        todo!()
    }

    /// Number of bodies.
    pub fn body_count(&self) -> usize {
        todo!()
    }

    /// Ids of the bodies, ascending.
    pub fn body_ids(&self) -> &[i64] {
        todo!()
    }

    /// Nodes of the facets, by body: `(body index, nodes)`; a quadrilateral face of a `Hex8` appears once.
    pub fn faces(&self) -> Vec<(usize, Vec<u32>)> {
        todo!()
    }
}
