//! Boundary of a mesh of cells.

use crate::Mesh;
use crate::second_order::middles;
use std::collections::HashMap;

/// Faces of a cell as local node numbers, outward.
pub(crate) fn faces(dimension: usize, nodes_per_cell: usize) -> &'static [&'static [usize]] {
    match (dimension, nodes_per_cell) {
        (2, 2) => &[&[0], &[1]],
        (2, 3) | (3, 3) => &[&[0, 1], &[1, 2], &[2, 0]],
        (2, 4) => &[&[0, 1], &[1, 2], &[2, 3], &[3, 0]],
        (3, 4) => &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[0, 3, 2]],
        (3, 5) => &[&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]],
        (3, 6) => &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
        (3, 8) => &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]],
        (d, n) => panic!("no cell of dimension {d} with {n} nodes"),
    }
}

/// Faces with all their nodes: of cells of second order the corners, then the middles of the edges between them, then that
/// of the face, as in `Tri6`, `Quad8` and `Quad9`.
fn faces_with_middles(dimension: usize, nodes_per_cell: usize) -> Vec<Vec<usize>> {
    let Some((corners, middles)) = middles(dimension, nodes_per_cell) else {
        return faces(dimension, nodes_per_cell).iter().map(|face| face.to_vec()).collect();
    };
    let middle = |around: &[usize]| {
        let is_it = |of: &Vec<usize>| of.len() == around.len() && around.iter().all(|corner| of.contains(corner));
        middles.iter().position(is_it).map(|place| corners + place)
    };
    let with_middles = |face: &&[usize]| {
        let mut all = face.to_vec();
        // In the plane a face is itself an edge.
        let edges = if dimension == 2 { 1 } else { face.len() };
        all.extend((0..edges).filter_map(|k| middle(&[face[k], face[(k + 1) % face.len()]])));
        all.extend(middle(face).filter(|_| face.len() > 3));
        all
    };
    faces(dimension, corners).iter().map(with_middles).collect()
}

/// The same as [`Mesh::boundary_faces`] of cells of several kinds on the same nodes: nodes of a cell, and the cells.
pub fn boundary_faces(dimension: usize, blocks: &[(usize, &[u32])]) -> Vec<Vec<u32>> {
    let mut all: Vec<Vec<u32>> = Vec::new();
    for &(nodes_per_cell, conn) in blocks {
        let local = faces_with_middles(dimension, nodes_per_cell);
        let of_cell =
            |cell: &[u32]| local.iter().map(|face| face.iter().map(|&k| cell[k]).collect()).collect::<Vec<_>>();
        all.extend(conn.chunks_exact(nodes_per_cell).flat_map(of_cell));
    }
    let sorted = |face: &Vec<u32>| {
        let mut key = face.clone();
        key.sort_unstable();
        key
    };
    let mut uses: HashMap<Vec<u32>, usize> = HashMap::new();
    all.iter().for_each(|face| *uses.entry(sorted(face)).or_default() += 1);
    all.retain(|face| uses[&sorted(face)] == 1);
    all
}

impl<const D: usize> Mesh<D> {
    /// Faces that belong to one cell only, outward, in the order of the cells; corners first, then the nodes in the middle of
    /// their edges and of themselves. Empty for a closed surface.
    pub fn boundary_faces(&self) -> Vec<Vec<u32>> {
        boundary_faces(D, &[(self.nodes_per_cell, &self.conn)])
    }

    /// Boundary as a surface of its own, with the nodes it uses.
    ///
    /// # Panics
    /// For cells with faces that are no triangles.
    pub fn boundary(&self) -> Self {
        let faces = self.boundary_faces();
        assert!(faces.iter().all(|face| face.len() == D), "quadrilateral faces are not facets");
        Self { coords: self.coords.clone(), conn: faces.concat(), nodes_per_cell: D }.without_unused_nodes()
    }

    /// Euler characteristic: nodes − edges (+ faces) of a surface in 3D or of cells in 2D; 2 for a sphere, 1 for a disc.
    pub fn euler_characteristic(&self) -> i64 {
        assert!(self.nodes_per_cell <= if D == 2 { 4 } else { 3 }, "only for surfaces and plane meshes");
        let local = faces(D, self.nodes_per_cell);
        let mut edges: Vec<[u32; 2]> = self
            .cells()
            .flat_map(|cell| local.iter().map(|e| [cell[e[0]].min(cell[e[1]]), cell[e[0]].max(cell[e[1]])]))
            .collect();
        edges.sort_unstable();
        edges.dedup();
        self.coords.len() as i64 - edges.len() as i64 + self.cell_count() as i64
    }
}

#[cfg(test)]
mod tests {
    use crate::{cuboid_hex8, cuboid_tet4, rectangle_quad4, second_order};

    /// Every node but the corners is the mean of its neighbours in the face, whose corners are those of the straight mesh.
    #[test]
    fn faces_have_their_middles() {
        let square = rectangle_quad4([0.0; 2], [1.0; 2], [2, 1]);
        let block = cuboid_hex8([0.0; 3], [1.0; 3], [2, 1, 1]);
        fn check<const D: usize>(straight: &crate::Mesh<D>, nodes: usize, in_face: usize) {
            let mesh = second_order(straight, nodes);
            let faces = mesh.boundary_faces();
            let corners = straight.boundary_faces();
            assert_eq!(faces.len(), corners.len());
            for (face, corners) in faces.iter().zip(&corners) {
                let count = corners.len();
                assert_eq!((face.len(), &face[..count]), (in_face, &corners[..]));
                let mean = |around: &[u32]| -> [f64; D] {
                    let sum = |i: usize| around.iter().map(|&k| mesh.coords[k as usize][i]).sum::<f64>();
                    std::array::from_fn(|i| sum(i) / around.len() as f64)
                };
                for (k, &node) in face[count..].iter().enumerate() {
                    let around = if k < count { vec![face[k], face[(k + 1) % count]] } else { corners.clone() };
                    assert_eq!(mesh.coords[node as usize], mean(&around));
                }
            }
        }
        check(&square.clone().triangulated(), 6, 3);
        check(&square, 8, 3);
        check(&square, 9, 3);
        check(&cuboid_tet4([0.0; 3], [1.0; 3], [2, 1, 1]), 10, 6);
        check(&block, 20, 8);
        check(&block, 27, 9);
    }

    #[test]
    fn boundary_encloses_the_cells() {
        let mesh = cuboid_tet4([0.0; 3], [1.0, 2.0, 3.0], [2, 3, 4]);
        let surface = mesh.boundary();
        assert_eq!(surface.cell_count(), 2 * 2 * (6 + 8 + 12));
        assert!((surface.measure() - 6.0).abs() < 1e-13);
        assert!(surface.boundary_faces().is_empty());
        assert_eq!(surface.euler_characteristic(), 2);
        let mesh = rectangle_quad4([0.0; 2], [2.0, 3.0], [4, 5]);
        assert!((mesh.boundary().measure() - 6.0).abs() < 1e-13);
        assert_eq!(mesh.boundary().cell_count(), 18);
        assert_eq!(cuboid_hex8([0.0; 3], [1.0; 3], [2, 3, 4]).boundary_faces().len(), 52);
    }
}
