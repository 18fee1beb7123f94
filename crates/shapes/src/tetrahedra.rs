//! Hexahedra cut into tetrahedra.

use crate::Mesh;

/// Neighbours of every corner of a hexahedron.
const NEIGHBOURS: [[usize; 3]; 8] =
    [[1, 3, 4], [0, 2, 5], [1, 3, 6], [0, 2, 7], [0, 5, 7], [1, 4, 6], [2, 5, 7], [3, 4, 6]];

impl Mesh<3> {
    /// `Hex8` cells cut into five `Tet4` each: one between the corners that are `even`, and one about each of the others. Of the
    /// ends of an edge one must be even, so that neighbours agree. Unlike six about a diagonal, they prefer no direction.
    pub(crate) fn tetrahedra(self, even: &[bool]) -> Self {
        assert_eq!(self.nodes_per_cell, 8, "only hexahedra can be cut");
        let mut conn = Vec::with_capacity(5 * self.conn.len() / 2);
        for cell in self.cells() {
            let is_even = |corner: &usize| even[cell[*corner] as usize];
            conn.extend((0..8).filter(is_even).map(|corner| cell[corner]));
            for corner in (0..8).filter(|corner| !is_even(corner)) {
                conn.push(cell[corner]);
                conn.extend(NEIGHBOURS[corner].map(|near| cell[near]));
            }
        }
        Self { coords: self.coords, conn, nodes_per_cell: 4 }.oriented()
    }
}
