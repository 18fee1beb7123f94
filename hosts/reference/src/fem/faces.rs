//! Faces of the boundary.

use super::Model;
use fmc_shapes::boundary_faces;

/// Face of one cell on the boundary of its part: an edge in 2D, a triangle or quadrilateral in 3D.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Face {
    /// Part that it belongs to.
    pub part: usize,
    /// Its nodes in the numbering of the model, counter-clockwise seen from outside (2D: body on the left).
    pub nodes: Vec<u32>,
}

impl<const D: usize> Model<D> {
    /// Faces of a part's boundary all of whose nodes lie, undeformed, where the condition holds.
    pub fn faces_where(&self, part: usize, condition: impl Fn(&[f64; D]) -> bool) -> Vec<Face> {
        let blocks: Vec<(usize, &[u32])> =
            self.elements_of(part).iter().map(|e| (e.cell_type.node_count(), e.conn.as_slice())).collect();
        let mut faces = boundary_faces(D, &blocks);
        faces.retain(|face| face.iter().all(|&node| condition(&self.coords()[node as usize])));
        faces.into_iter().map(|nodes| Face { part, nodes }).collect()
    }
}
