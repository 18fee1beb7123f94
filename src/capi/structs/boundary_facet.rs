//! A boundary facet as a plain struct.

use crate::BoundaryFacet;

/// A boundary facet: an edge in 2D, a triangle in 3D. A quadrilateral face is four of them, one on each of its edges. A face
/// of a cell of second order is divided first: an edge in two, a triangle or quadrilateral in four parts.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_boundary_facet {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Its body, an index for `fmc_context_body_resultant`.
    pub body: usize,
    /// Its cell, counted from the option `index_base` over all blocks; -1 where the context was made from facets.
    pub cell: i64,
    /// Its number among the facets that the context was made from, counted from `index_base` over all blocks; -1 where it was made
    /// from cells.
    pub input_facet: i64,
    /// Number of its face in the cell, as VTK counts them, always from 0; -1 without cells. The corners of face 0, 1, ... by their
    /// place in the cell, in VTK's order: triangle 01, 12, 20. Quadrilateral 01, 12, 23, 30. Tetrahedron 013, 123, 203, 021. Hexahedron
    /// 0473, 1265, 0154, 3762, 0321, 4567. Wedge 012, 354, 0341, 1452, 2530. Pyramid 0321, 014, 124, 234, 304.
    pub local_face: i32,
    /// Number of nodes of its face: 2 in 2D, 3 or 4 in 3D; on a face of second order, of the part in which the facet
    /// lies.
    pub node_count: i32,
    /// Nodes of its face, counted from the option `index_base`; unused ones are -1. In 2D the body lies left of the way from
    /// the first to the second. In 3D they run counter-clockwise seen from outside, also where the cell is numbered the other
    /// way round. With four nodes the facet is the triangle of the first two and the mean of all. On a face of second order
    /// they are points of its division, see `fmc_context_point_weights`; numbers from the node count on are not nodes.
    pub nodes: [i64; 4],
    /// Zero.
    pub reserved: [u64; 4],
}

impl fmc_boundary_facet {
    pub(crate) fn new(facet: &BoundaryFacet, index_base: i32) -> Self {
        let number = |number: usize| number as i64 + i64::from(index_base);
        let node = |k: usize| facet.nodes.get(k).map_or(-1, |&node| i64::from(node) + i64::from(index_base));
        Self {
            struct_size: size_of::<Self>(),
            body: facet.body,
            cell: facet.cell.map_or(-1, number),
            input_facet: facet.given.map_or(-1, number),
            local_face: facet.local_face.map_or(-1, |face| face as i32),
            node_count: facet.nodes.len() as i32,
            nodes: std::array::from_fn(node),
            reserved: [0; 4],
        }
    }
}
