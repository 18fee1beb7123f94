//! Nodes, faces and corners of the cell types.

use super::CellType;

impl CellType {
    /// Dimension of the space that the cell fills, 2 or 3.
    pub fn dimension(self) -> usize {
        match self.straight() {
            CellType::Tri3 | CellType::Quad4 => 2,
            _ => 3,
        }
    }

    /// Number of nodes.
    pub fn node_count(self) -> usize {
        match self {
            CellType::Tri3 => 3,
            CellType::Quad4 | CellType::Tet4 => 4,
            CellType::Hex8 | CellType::Quad8 => 8,
            CellType::Wedge6 | CellType::Tri6 => 6,
            CellType::Pyramid5 => 5,
            CellType::Quad9 => 9,
            CellType::Tet10 => 10,
            CellType::Hex20 => 20,
            CellType::Hex27 => 27,
            CellType::Wedge15 => 15,
            CellType::Pyramid13 => 13,
        }
    }

    /// The cell of first order with the same corners, which come first; itself where it is of first order.
    pub fn straight(self) -> CellType {
        match self {
            CellType::Tri3 | CellType::Tri6 => CellType::Tri3,
            CellType::Quad4 | CellType::Quad8 | CellType::Quad9 => CellType::Quad4,
            CellType::Tet4 | CellType::Tet10 => CellType::Tet4,
            CellType::Hex8 | CellType::Hex20 | CellType::Hex27 => CellType::Hex8,
            CellType::Wedge6 | CellType::Wedge15 => CellType::Wedge6,
            CellType::Pyramid5 | CellType::Pyramid13 => CellType::Pyramid5,
        }
    }

    /// Corners of its faces as local node numbers: edges in 2D, triangles or quadrilaterals in 3D, seen from outside the
    /// cell counter-clockwise (2D: with the cell on the left).
    pub fn faces(self) -> &'static [&'static [usize]] {
        match self.straight() {
            CellType::Tri3 => &[&[0, 1], &[1, 2], &[2, 0]],
            CellType::Quad4 => &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]],
            CellType::Tet4 => &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[0, 3, 2]],
            CellType::Wedge6 => &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
            CellType::Pyramid5 => &[&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]],
            _ => &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]],
        }
    }

    /// Whether it is a triangle or a tetrahedron of first order.
    pub(crate) fn is_simplex(self) -> bool {
        matches!(self, CellType::Tri3 | CellType::Tet4)
    }

    /// The number that VTK gives to a face, by its place in [`Self::faces`]: in 2D the same. As node numbers VTK's faces are
    /// those of `vtkTetra`, 013, 123, 203 and 021, of `vtkHexahedron`, 0473, 1265, 0154, 3762, 0321 and 4567, of `vtkWedge`, 012, 354, 0341, 1452 and 2530, and of
    /// `vtkPyramid`, 0321, 014, 124, 234 and 304, and the same for cells of second order.
    ///
    /// # Panics
    /// For a face that the cell does not have.
    pub fn vtk_face(self, face: usize) -> usize {
        match self.straight() {
            CellType::Tri3 => [0, 1, 2][face],
            CellType::Quad4 => [0, 1, 2, 3][face],
            CellType::Tet4 => [3, 0, 1, 2][face],
            CellType::Wedge6 | CellType::Pyramid5 => [0, 1, 2, 3, 4][face],
            _ => [4, 5, 2, 1, 3, 0][face],
        }
    }

    /// For every corner, its node and those whose edges from it span the corner's Jacobian, D + 1 in all. Of a pyramid
    /// those of the base: the Jacobian of the map from the cube is bilinear over the base, and so positive within if it is
    /// positive at its corners; at the apex it vanishes.
    pub(crate) fn corners(self) -> &'static [&'static [usize]] {
        match self.straight() {
            CellType::Tri3 => &[&[0, 1, 2]],
            CellType::Quad4 => &[&[0, 1, 3], &[1, 2, 0], &[2, 3, 1], &[3, 0, 2]],
            CellType::Tet4 => &[&[0, 1, 2, 3]],
            CellType::Wedge6 => {
                &[&[0, 1, 2, 3], &[1, 2, 0, 4], &[2, 0, 1, 5], &[3, 5, 4, 0], &[4, 3, 5, 1], &[5, 4, 3, 2]]
            }
            CellType::Pyramid5 => &[&[0, 1, 3, 4], &[1, 2, 0, 4], &[2, 3, 1, 4], &[3, 0, 2, 4]],
            _ => &[
                &[0, 1, 3, 4],
                &[1, 2, 0, 5],
                &[2, 3, 1, 6],
                &[3, 0, 2, 7],
                &[4, 7, 5, 0],
                &[5, 4, 6, 1],
                &[6, 5, 7, 2],
                &[7, 6, 4, 3],
            ],
        }
    }
}
