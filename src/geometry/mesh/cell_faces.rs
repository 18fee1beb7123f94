//! Nodes, faces and corners of the cell types.

use crate::geometry::CellType;

/// Every type with its name in meshio and its number in VTK. A new type is a row here and in the matches below.
const TABLE: [(CellType, &str, i32); 14] = [
    (CellType::Tri3, "triangle", 5),
    (CellType::Quad4, "quad", 9),
    (CellType::Tet4, "tetra", 10),
    (CellType::Hex8, "hexahedron", 12),
    (CellType::Wedge6, "wedge", 13),
    (CellType::Pyramid5, "pyramid", 14),
    (CellType::Tri6, "triangle6", 22),
    (CellType::Quad8, "quad8", 23),
    (CellType::Quad9, "quad9", 28),
    (CellType::Tet10, "tetra10", 24),
    (CellType::Hex20, "hexahedron20", 25),
    (CellType::Hex27, "hexahedron27", 29),
    (CellType::Wedge15, "wedge15", 26),
    (CellType::Pyramid13, "pyramid13", 27),
];

impl CellType {
    /// All types, those of first order first.
    pub fn all() -> impl Iterator<Item = CellType> {
        TABLE.into_iter().map(|(cell_type, ..)| cell_type)
    }

    /// Its name in meshio.
    pub fn name(self) -> &'static str {
        self.row().1
    }

    /// Its number in VTK, and in the C interface.
    pub fn vtk_number(self) -> i32 {
        self.row().2
    }

    /// The type of a number of VTK.
    pub fn of_vtk_number(number: i32) -> Option<CellType> {
        TABLE.into_iter().find_map(|(cell_type, _, of_vtk)| (of_vtk == number).then_some(cell_type))
    }

    /// Its row in the table, which has one for every type (a test).
    fn row(self) -> (CellType, &'static str, i32) {
        TABLE.into_iter().find(|row| row.0 == self).unwrap_or(TABLE[0])
    }

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

#[cfg(test)]
mod tests {
    use super::{CellType, TABLE};

    /// VTK numbers its linear cells below 15 and those of second order from 22; corners are numbered first in all of them.
    #[test]
    fn every_type_has_one_row() {
        for (row, (cell_type, name, number)) in TABLE.into_iter().enumerate() {
            assert_eq!(CellType::of_vtk_number(number), Some(cell_type));
            assert_eq!((cell_type.name(), cell_type.vtk_number()), (name, number));
            assert_eq!(number < 15, cell_type.straight() == cell_type);
            assert!(TABLE[..row].iter().all(|other| other.0 != cell_type && other.1 != name && other.2 != number));
            // A variant without a row would answer with the first one.
            match cell_type {
                CellType::Tri3 | CellType::Quad4 | CellType::Tet4 | CellType::Hex8 | CellType::Wedge6 => {}
                CellType::Pyramid5 | CellType::Tri6 | CellType::Quad8 | CellType::Quad9 | CellType::Tet10 => {}
                CellType::Hex20 | CellType::Hex27 | CellType::Wedge15 | CellType::Pyramid13 => {}
            }
        }
        assert_eq!(CellType::all().count(), 14);
    }
}
