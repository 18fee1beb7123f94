//! Blocks whose cells are small about one corner of their top, where a tip will press.
//!
//! ```text
//!   o--+--+-------+-------------   top, last axis = 0; the tip at o
//!   +--+--+       |
//!   +--+--+-------+                a core of equal cells, and about it shells that are copies of its outer faces, each
//!   |      \      |                larger than the one before by the same factor, up to the outline
//!   +-------+-----+
//! ```

use crate::Mesh;
use std::collections::BTreeMap;

/// Block [0, size₀] × … × [−size, 0] in quadrilaterals: a core of `cells` × `cells` cells and of side `fine` at the origin, and
/// `shells` shells about it.
pub fn graded_block_quad4(size: [f64; 2], fine: f64, cells: usize, shells: usize) -> Mesh<2> {
    let (coords, corners, _) = graded_block(size, fine, cells, shells);
    let conn = corners.chunks_exact(4).flat_map(|c| [c[0], c[1], c[3], c[2]]).collect();
    Mesh { coords, conn, nodes_per_cell: 4 }.oriented()
}

/// The same in triangles, two per quadrilateral.
pub fn graded_block_tri3(size: [f64; 2], fine: f64, cells: usize, shells: usize) -> Mesh<2> {
    graded_block_quad4(size, fine, cells, shells).triangulated()
}

/// The same in hexahedra, in space.
pub fn graded_block_hex8(size: [f64; 3], fine: f64, cells: usize, shells: usize) -> Mesh<3> {
    let (coords, corners, _) = graded_block(size, fine, cells, shells);
    let conn = corners.chunks_exact(8).flat_map(|c| [c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]]).collect();
    Mesh { coords, conn, nodes_per_cell: 8 }.oriented()
}

/// The same in tetrahedra, five per hexahedron.
pub fn graded_block_tet4(size: [f64; 3], fine: f64, cells: usize, shells: usize) -> Mesh<3> {
    let (.., even) = graded_block(size, fine, cells, shells);
    graded_block_hex8(size, fine, cells, shells).tetrahedra(&even)
}

/// Nodes; the 2ᴰ corners of every cell, where bit a of a corner's number says on which side along axis a it lies; and which
/// nodes are even, as are the fields of a chess board: of the ends of every edge, one.
fn graded_block<const D: usize>(
    size: [f64; D],
    fine: f64,
    cells: usize,
    shells: usize,
) -> (Vec<[f64; D]>, Vec<u32>, Vec<bool>) {
    assert!(fine > 0.0 && cells > 0 && size.iter().all(|s| *s >= fine), "a core of {fine} in {size:?}");
    assert!(shells > 0 || size.iter().all(|s| *s == fine), "no shells from {fine} to {size:?}");
    let (mut coords, mut ids) = (Vec::new(), BTreeMap::new());
    // A node by its shell, 0 for the core, and its place on the lattice of the core.
    let mut node = |shell: usize, at: [usize; D]| {
        *ids.entry((shell, at)).or_insert_with(|| {
            let part = if shells == 0 { 0.0 } else { shell as f64 / shells as f64 };
            coords.push(std::array::from_fn(|a| {
                let reach = if shell == shells { size[a] } else { fine * (size[a] / fine).powf(part) };
                let x = reach * at[a] as f64 / cells as f64;
                if a + 1 == D { -x } else { x }
            }));
            coords.len() as u32 - 1
        })
    };
    let mut corners = Vec::new();
    let lattice = |axes: usize| (0..cells.pow(axes as u32)).map(move |k| (k, axes));
    for (k, _) in lattice(D) {
        let low: [usize; D] = std::array::from_fn(|a| k / cells.pow(a as u32) % cells);
        corners.extend((0..1 << D).map(|c| node(0, std::array::from_fn(|a| low[a] + (c >> a & 1)))));
    }
    for (shell, axis) in (1..=shells).flat_map(|shell| (0..D).map(move |axis| (shell, axis))) {
        for (k, _) in lattice(D - 1) {
            // Place on the face across `axis`: the other axes in their order.
            let other = |a: usize| if a < axis { a } else { a - 1 };
            corners.extend((0..1 << D).map(|c| {
                let along = |a: usize| {
                    if a == axis { cells } else { k / cells.pow(other(a) as u32) % cells + (c >> a & 1) }
                };
                node(shell - 1 + (c >> axis & 1), std::array::from_fn(along))
            }));
        }
    }
    let mut even = vec![false; coords.len()];
    for ((shell, at), id) in ids {
        even[id as usize] = (shell + at.iter().sum::<usize>()).is_multiple_of(2);
    }
    (coords, corners, even)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn graded_blocks_fill_their_outline() {
        let (flat, solid) = ([2.5, 5.0], [2.5, 2.0, 3.0]);
        for mesh in [graded_block_quad4(flat, 0.1, 4, 5), graded_block_tri3(flat, 0.1, 4, 5)] {
            assert!((mesh.measure() - 12.5).abs() < 1e-12 && mesh.smallest_jacobian() > 0.0);
            assert_eq!((mesh.euler_characteristic(), mesh.boundary().cell_count()), (1, 8 + 8 + 2 * 5));
        }
        for mesh in [graded_block_hex8(solid, 0.1, 3, 4), graded_block_tet4(solid, 0.1, 3, 4)] {
            assert!((mesh.measure() - 15.0).abs() < 1e-12 && mesh.smallest_jacobian() > 0.0);
            let faces = 6 * 9 + 3 * 2 * 3 * 4;
            assert_eq!(mesh.boundary_faces().len(), if mesh.nodes_per_cell == 8 { faces } else { 2 * faces });
        }
    }
}
