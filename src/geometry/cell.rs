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
}

impl CellType {
    /// Dimension of the space that the cell fills, 2 or 3.
    pub fn dimension(self) -> usize {
        match self {
            CellType::Tri3 | CellType::Quad4 => 2,
            CellType::Tet4 | CellType::Hex8 | CellType::Wedge6 | CellType::Pyramid5 => 3,
        }
    }

    /// Number of nodes.
    pub fn node_count(self) -> usize {
        match self {
            CellType::Tri3 => 3,
            CellType::Quad4 | CellType::Tet4 => 4,
            CellType::Hex8 => 8,
            CellType::Wedge6 => 6,
            CellType::Pyramid5 => 5,
        }
    }

    /// Faces as local node numbers: edges in 2D, triangles or quadrilaterals in 3D, seen from outside the cell
    /// counter-clockwise (2D: with the cell on the left).
    pub fn faces(self) -> &'static [&'static [usize]] {
        match self {
            CellType::Tri3 => &[&[0, 1], &[1, 2], &[2, 0]],
            CellType::Quad4 => &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]],
            CellType::Tet4 => &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[0, 3, 2]],
            CellType::Hex8 => {
                &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]]
            }
            CellType::Wedge6 => &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
            CellType::Pyramid5 => &[&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]],
        }
    }

    /// Whether it is a triangle or a tetrahedron.
    pub(crate) fn is_simplex(self) -> bool {
        matches!(self, CellType::Tri3 | CellType::Tet4)
    }

    /// The number that VTK gives to a face, by its place in [`Self::faces`]: in 2D the same. As node numbers VTK's faces are
    /// those of `vtkTetra`, 013, 123, 203 and 021, of `vtkHexahedron`, 0473, 1265, 0154, 3762, 0321 and 4567, of `vtkWedge`, 012, 354, 0341, 1452 and 2530, and of
    /// `vtkPyramid`, 0321, 014, 124, 234 and 304.
    ///
    /// # Panics
    /// For a face that the cell does not have.
    pub fn vtk_face(self, face: usize) -> usize {
        match self {
            CellType::Tri3 => [0, 1, 2][face],
            CellType::Quad4 => [0, 1, 2, 3][face],
            CellType::Tet4 => [3, 0, 1, 2][face],
            CellType::Hex8 => [4, 5, 2, 1, 3, 0][face],
            CellType::Wedge6 | CellType::Pyramid5 => [0, 1, 2, 3, 4][face],
        }
    }

    /// For every corner, its node and those whose edges from it span the corner's Jacobian, D + 1 in all. Of a pyramid
    /// those of the base: the Jacobian of the map from the cube is bilinear over the base, and so positive within if it is
    /// positive at its corners; at the apex it vanishes.
    pub(crate) fn corners(self) -> &'static [&'static [usize]] {
        match self {
            CellType::Tri3 => &[&[0, 1, 2]],
            CellType::Quad4 => &[&[0, 1, 3], &[1, 2, 0], &[2, 3, 1], &[3, 0, 2]],
            CellType::Tet4 => &[&[0, 1, 2, 3]],
            CellType::Hex8 => &[
                &[0, 1, 3, 4],
                &[1, 2, 0, 5],
                &[2, 3, 1, 6],
                &[3, 0, 2, 7],
                &[4, 7, 5, 0],
                &[5, 4, 6, 1],
                &[6, 5, 7, 2],
                &[7, 6, 4, 3],
            ],
            CellType::Wedge6 => {
                &[&[0, 1, 2, 3], &[1, 2, 0, 4], &[2, 0, 1, 5], &[3, 5, 4, 0], &[4, 3, 5, 1], &[5, 4, 3, 2]]
            }
            CellType::Pyramid5 => &[&[0, 1, 3, 4], &[1, 2, 0, 4], &[2, 3, 1, 4], &[3, 0, 2, 4]],
        }
    }
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
