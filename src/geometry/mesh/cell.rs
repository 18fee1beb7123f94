//! Volume pieces and their node order.

/// Type of a cell. Node order is that of Gmsh, meshio, Abaqus and most codes, and of VTK but for `Wedge6`:
///
/// ```text
///   Tri3     2          Quad4  3 --- 2     Tet4       3          Hex8     7 ---- 6
///           / \                |     |               /|\                 /|     /|
///          /   \               |     |              / | \               4 ---- 5 |
///         0 --- 1              0 --- 1             0 -|- 2              | 3 ---| 2
///                                                   \ | /               |/     |/
///        counter-clockwise                            1                 0 ---- 1
///
///   Wedge6   5               Pyramid5    4
///           /|\                       // \\
///          3 --- 4                    / | | \
///          | 2   |                   /  3 ---- 2
///          |/ \  |                  / /  \   /
///          0 --- 1                  0 ------ 1
/// ```
///
/// In a `Wedge6` the first triangle is counter-clockwise seen from the second, (x1 − x0) × (x2 − x0) · (x3 − x0) > 0. VTK
/// defines its wedge the other way round, though the files that meshio and others write are in Gmsh's order. Both are taken:
/// the one is the other's mirror image, as for cells of every type (see [`CellBlock`]).
///
/// Cells of second order have the corners of the straight cell first, then the nodes in the middle of edges, given here by
/// the edge's ends, in the order of meshio and VTK (Gmsh has another one for `Tet10`, `Hex20`, `Hex27`, `Wedge15` and
/// `Pyramid13`):
///
/// ```text
///   Tri6       01 12 20                     Quad8, Quad9   01 12 23 30, then the middle
///   Tet10      01 12 20 03 13 23
///   Hex20      01 12 23 30 45 56 67 74 04 15 26 37
///   Hex27      those, then the faces 0473 1265 0154 3762 0321 4567, then the middle
///   Wedge15    01 12 20 34 45 53 03 14 25
///   Pyramid13  01 12 23 30 04 14 24 34
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum CellType {
    /// Triangle, 2D.
    Tri3,
    /// Quadrilateral, 2D.
    Quad4,
    /// Tetrahedron, 3D.
    Tet4,
    /// Hexahedron, 3D.
    Hex8,
    /// Wedge, 3D: two triangles, the second above the first, and three quadrilaterals.
    Wedge6,
    /// Pyramid, 3D: four nodes around the base, then the apex.
    Pyramid5,
    /// Triangle with a node in the middle of each edge, 2D.
    Tri6,
    /// Quadrilateral with a node in the middle of each edge, 2D: serendipity.
    Quad8,
    /// Quadrilateral with nodes in the middle of each edge and of itself, 2D.
    Quad9,
    /// Tetrahedron with a node in the middle of each edge, 3D.
    Tet10,
    /// Hexahedron with a node in the middle of each edge, 3D: serendipity.
    Hex20,
    /// Hexahedron with nodes in the middle of each edge, of each face and of itself, 3D.
    Hex27,
    /// Wedge with a node in the middle of each edge, 3D.
    Wedge15,
    /// Pyramid with a node in the middle of each edge, 3D.
    Pyramid13,
}

/// Cells of one type: `conn` holds `node_count` node ids per cell, cell after cell. Ids are zero-based.
///
/// Cells may be given in either orientation, also mixed, as meshes of simplices often are: the orientation of a body
/// follows from its connectivity and from the sign of its volume.
#[derive(Clone, Copy, Debug)]
pub struct CellBlock<'a> {
    /// Type of all cells of the block.
    pub cell_type: CellType,
    /// Node ids, `[cell_count, node_count]`.
    pub conn: &'a [u32],
}

/// Which body a cell (or facet) belongs to.
#[derive(Clone, Copy, Debug, Default)]
pub enum Bodies<'a> {
    /// Bodies are the connected components: cells that share a face, facets that share a node. They are numbered
    /// 0, 1, … by their first cell.
    #[default]
    Connected,
    /// One id per cell (or facet), counted over all blocks. Any numbers; results are ordered by id.
    Ids(&'a [i64]),
}
