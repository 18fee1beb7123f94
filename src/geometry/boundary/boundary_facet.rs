//! The boundary facets of a mesh, as a host asks for them.

use crate::geometry::{CellType, Surface};

/// A boundary facet: an edge in 2D, a triangle in 3D. A quadrilateral face is four of them, one on each of its edges. A face
/// of second order is divided first, an edge in two, a triangle or quadrilateral in four.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BoundaryFacet {
    /// Index of its body.
    pub body: usize,
    /// Its cell, counted over all blocks; `None` where the surface was given by facets.
    pub cell: Option<usize>,
    /// Number of its face among those of the cell, as VTK counts them ([`CellType::vtk_face`](crate::geometry::CellType::vtk_face)).
    pub local_face: Option<usize>,
    /// Its number among the facets as given; `None` where the surface was made from cells.
    pub given: Option<usize>,
    /// Nodes of its face: in 2D with the body on the left, in 3D counter-clockwise seen from outside. Of four, the facet
    /// is the triangle of the first two and the mean of all. Of a face of second order those of the part to which the
    /// facet belongs; numbers from the node count on are middles of faces in which there is no node.
    pub nodes: Vec<u32>,
}

impl<const D: usize> Surface<D> {
    /// All boundary facets, in the order in which everything is told of them: body after body, by cell and face.
    #[inline(never)]
    pub fn boundary_facets(&self) -> Vec<BoundaryFacet> {
        let bodies =
            self.ranges.iter().enumerate().flat_map(|(body, range)| range.clone().map(move |facet| (body, facet)));
        bodies.map(|(body, facet)| self.boundary_facet(body, facet)).collect()
    }

    fn boundary_facet(&self, body: usize, facet: usize) -> BoundaryFacet {
        let source = self.facet_source[facet] as usize;
        let cell = self.facet_cell.get(facet).map(|&cell| cell as usize);
        let of_whole = |cell: usize| {
            let (whole, face) = match &self.division {
                Some(division) => (division.cell(cell), division.face(cell, source)),
                None => (cell, Some(source)),
            };
            let of_whole = self.division.as_ref().and_then(|division| division.cell_type(cell));
            let cell_type = of_whole.or_else(|| self.cells.as_ref().map(|cells| cells.cell_type(cell)));
            let as_given = self.collapsed.get(&(whole as u32));
            let face_number = |(cell_type, face): (CellType, usize)| match as_given {
                Some(faces) => faces[face],
                None => cell_type.vtk_face(face),
            };
            (Some(whole), cell_type.zip(face).map(face_number))
        };
        let (cell, local_face) = cell.map_or((None, None), of_whole);
        let of_given = || self.division.as_ref().map_or(source, |division| division.cell(source));
        let given = cell.is_none().then(of_given);
        BoundaryFacet { body, cell, local_face, given, nodes: self.nodes_of_facet(facet) }
    }

    /// Nodes of the face of a facet, from the facet's first on.
    fn nodes_of_facet(&self, facet: usize) -> Vec<u32> {
        let vertices = self.facets[facet];
        let node = |&vertex: &u32| self.nodes[vertex as usize];
        let Some(centroid) = (vertices[D - 1] as usize).checked_sub(self.nodes.len()) else {
            return vertices.iter().map(node).collect();
        };
        let mut four = self.centroids[centroid];
        let first = four.iter().position(|&vertex| vertex == vertices[0]).unwrap_or(0);
        four.rotate_left(first);
        four.iter().map(node).collect()
    }
}
