//! Faces of the boundary.

use super::Model;

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
        let first = self.nodes_of(part).start as u32;
        let mut faces = self.parts()[part].mesh.boundary_faces();
        faces.retain(|face| face.iter().all(|&node| condition(&self.parts()[part].mesh.coords[node as usize])));
        faces.into_iter().map(|face| Face { part, nodes: face.iter().map(|node| node + first).collect() }).collect()
    }
}
