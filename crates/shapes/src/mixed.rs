//! Boxes in wedges, in pyramids, and in cells of all four types.

use crate::{Mesh, cuboid_hex8};

/// Faces of a hexahedron, outward; the second is the top.
const FACES: [[usize; 4]; 6] = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

/// Box in wedges that stand upright, two per hexahedron.
pub fn cuboid_wedge6(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Mesh<3> {
    let Mesh { coords, conn, .. } = cuboid_hex8(min, max, cells);
    Mesh { coords, conn: conn.chunks_exact(8).flat_map(wedges).collect(), nodes_per_cell: 6 }
}

/// Box in pyramids, six per hexahedron about its centre; the centres are the last nodes.
pub fn cuboid_pyramid5(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Mesh<3> {
    let Mesh { mut coords, conn, .. } = cuboid_hex8(min, max, cells);
    let mut pyramids = Vec::new();
    for cell in conn.chunks_exact(8) {
        let centre = add_centre(&mut coords, cell);
        FACES.iter().for_each(|face| pyramids.extend(pyramid(cell, face, centre)));
    }
    Mesh { coords, conn: pyramids, nodes_per_cell: 5 }
}

/// Box in hexahedra, wedges, pyramids and tetrahedra: four meshes on the same nodes. The lowest layer is of hexahedra, the
/// next of five pyramids and, below the top, two tetrahedra per hexahedron, those above of wedges.
///
/// # Panics
/// For fewer than three layers.
pub fn cuboid_mixed(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> [Mesh<3>; 4] {
    assert!(cells[2] > 2, "expected a layer of each kind");
    let Mesh { mut coords, conn, .. } = cuboid_hex8(min, max, cells);
    let (mut hexahedra, mut prisms, mut pyramids, mut tetrahedra) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    // x runs fastest, then y.
    let per_layer = cells[0] * cells[1];
    for (number, cell) in conn.chunks_exact(8).enumerate() {
        match number / per_layer {
            0 => hexahedra.extend_from_slice(cell),
            1 => {
                let centre = add_centre(&mut coords, cell);
                let sides = FACES.iter().enumerate().filter(|(face, _)| *face != 1);
                sides.for_each(|(_, face)| pyramids.extend(pyramid(cell, face, centre)));
                tetrahedra.extend([cell[4], cell[6], cell[5], centre, cell[4], cell[7], cell[6], centre]);
            }
            _ => prisms.extend(wedges(cell)),
        }
    }
    [(8, hexahedra), (6, prisms), (5, pyramids), (4, tetrahedra)].map(|(nodes_per_cell, conn)| Mesh {
        coords: coords.clone(),
        conn,
        nodes_per_cell,
    })
}

/// The two wedges of a hexahedron, cut along the diagonals from its first node.
fn wedges(cell: &[u32]) -> [u32; 12] {
    [0, 1, 2, 4, 5, 6, 0, 2, 3, 4, 6, 7].map(|k| cell[k])
}

/// The pyramid over a face, its apex within.
fn pyramid(cell: &[u32], face: &[usize; 4], apex: u32) -> [u32; 5] {
    [cell[face[3]], cell[face[2]], cell[face[1]], cell[face[0]], apex]
}

fn add_centre(coords: &mut Vec<[f64; 3]>, cell: &[u32]) -> u32 {
    let sum = |axis: usize| cell.iter().map(|&node| coords[node as usize][axis]).sum::<f64>();
    coords.push([0, 1, 2].map(|axis| sum(axis) / 8.0));
    coords.len() as u32 - 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_fill_their_volume() {
        let (min, max, cells) = ([-1.0, 0.0, 2.0], [1.0, 3.0, 3.0], [2, 3, 4]);
        for (mesh, faces) in [(cuboid_wedge6(min, max, cells), 64), (cuboid_pyramid5(min, max, cells), 52)] {
            assert!((mesh.measure() - 6.0).abs() < 1e-13, "{}", mesh.measure());
            assert!(mesh.smallest_jacobian() > 0.0);
            assert_eq!(mesh.boundary_faces().len(), faces);
            let mirrored = mesh.clone().mapped(|x| [-x[0], x[1], x[2]]);
            assert!(mirrored.smallest_jacobian() < 0.0 && mirrored.oriented().smallest_jacobian() > 0.0);
        }
        let mixed = cuboid_mixed(min, max, cells);
        assert!((mixed.iter().map(Mesh::measure).sum::<f64>() - 6.0).abs() < 1e-13);
        assert!(mixed.iter().all(|mesh| mesh.cell_count() > 0 && mesh.smallest_jacobian() > 0.0));
    }
}
