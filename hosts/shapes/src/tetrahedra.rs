//! Hexahedra cut into tetrahedra.

use crate::Mesh;

/// Faces of a hexahedron.
const FACES: [[usize; 4]; 6] = [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

impl Mesh<3> {
    /// `Hex8` cells cut into six `Tet4` each, all about the node of lowest number, as are the faces: so neighbours agree.
    pub fn tetrahedra(self) -> Self {
        assert_eq!(self.nodes_per_cell, 8, "only hexahedra can be cut");
        let mut conn = Vec::with_capacity(3 * self.conn.len());
        for cell in self.cells() {
            let apex = *cell.iter().min().expect("eight nodes");
            for face in FACES.map(|face| face.map(|node| cell[node])).iter().filter(|face| !face.contains(&apex)) {
                let first = (0..4).min_by_key(|&k| face[k]).unwrap_or(0);
                for k in 1..3 {
                    conn.extend([apex, face[first], face[(first + k) % 4], face[(first + k + 1) % 4]]);
                }
            }
        }
        Self { coords: self.coords, conn, nodes_per_cell: 4 }.oriented()
    }
}
