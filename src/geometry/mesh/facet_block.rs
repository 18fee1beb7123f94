//! Pieces of a surface and their node order.

/// Type of a facet of a surface that is given without cells. Edges have the body on their left; triangles and quadrilaterals
/// run counter-clockwise seen from outside. Corners come first, then the nodes in the middle of edges, here by the edge's ends,
/// as meshio and VTK have them:
///
/// ```text
///   Line3   01                Tri6   01 12 20
///   Quad8   01 12 23 30       Quad9  01 12 23 30, then the middle
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum FacetType {
    /// Edge, 2D.
    Line2,
    /// Edge with a node in its middle, 2D.
    Line3,
    /// Triangle, 3D.
    Tri3,
    /// Triangle with a node in the middle of each edge, 3D.
    Tri6,
    /// Quadrilateral, 3D.
    Quad4,
    /// Quadrilateral with a node in the middle of each edge, 3D: a face of `Hex20`.
    Quad8,
    /// Quadrilateral with nodes in the middle of each edge and of itself, 3D: a face of `Hex27`.
    Quad9,
}

impl FacetType {
    /// Dimension of the bodies that it bounds.
    pub fn dimension(self) -> usize {
        match self {
            FacetType::Line2 | FacetType::Line3 => 2,
            _ => 3,
        }
    }

    /// Nodes of a facet.
    pub fn node_count(self) -> usize {
        match self {
            FacetType::Line2 => 2,
            FacetType::Line3 | FacetType::Tri3 => 3,
            FacetType::Quad4 => 4,
            FacetType::Tri6 => 6,
            FacetType::Quad8 => 8,
            FacetType::Quad9 => 9,
        }
    }

    /// Corners of a facet, which are its first nodes.
    pub fn corner_count(self) -> usize {
        match self {
            FacetType::Line2 | FacetType::Line3 => 2,
            FacetType::Tri3 | FacetType::Tri6 => 3,
            _ => 4,
        }
    }
}

/// Facets of one type: `conn` holds `node_count` node ids per facet, facet after facet. Ids are zero-based.
#[derive(Clone, Copy, Debug)]
pub struct FacetBlock<'a> {
    /// Type of all facets of the block.
    pub facet_type: FacetType,
    /// Node ids, `[facet_count, node_count]`.
    pub conn: &'a [u32],
}
