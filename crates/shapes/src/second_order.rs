//! Cells of second order from straight ones.

use crate::Mesh;
use std::collections::BTreeMap;

const HEX_EDGES: [[usize; 2]; 12] =
    [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];
const QUAD_EDGES: [[usize; 2]; 4] = [[0, 1], [1, 2], [2, 3], [3, 0]];

/// Number of corners, and the corners whose mean is each further node, in meshio's order, for a cell of `nodes` nodes in
/// dimension `dimension`; `None` if that is no cell of second order.
pub(crate) fn middles(dimension: usize, nodes: usize) -> Option<(usize, Vec<Vec<usize>>)> {
    let of = |corners: usize, edges: &[[usize; 2]]| (corners, edges.iter().map(|ends| ends.to_vec()).collect());
    Some(match (dimension, nodes) {
        (2, 6) => of(3, &[[0, 1], [1, 2], [2, 0]]),
        (2, 8) => of(4, &QUAD_EDGES),
        (2, 9) => {
            let (corners, edges) = of(4, &QUAD_EDGES);
            (corners, [edges, vec![vec![0, 1, 2, 3]]].concat())
        }
        (3, 10) => of(4, &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]]),
        (3, 13) => of(5, &[[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 4], [2, 4], [3, 4]]),
        (3, 15) => of(6, &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3], [0, 3], [1, 4], [2, 5]]),
        (3, 20) => of(8, &HEX_EDGES),
        (3, 27) => {
            let faces = [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]];
            let (corners, edges) = of(8, &HEX_EDGES);
            (corners, [edges, faces.map(|face| face.to_vec()).to_vec(), vec![(0..8).collect()]].concat())
        }
        _ => return None,
    })
}

/// The cells of `mesh` with nodes in their middles, `nodes_per_cell` in all; every edge keeps straight sides. New nodes come
/// after the old ones, in the order of the cells.
///
/// # Panics
/// For a number of nodes that no cell of second order with these corners has.
pub fn second_order<const D: usize>(mesh: &Mesh<D>, nodes_per_cell: usize) -> Mesh<D> {
    let Some((corners, middles)) = middles(D, nodes_per_cell) else {
        panic!("no cell of second order has {nodes_per_cell} nodes in dimension {D}");
    };
    assert_eq!(mesh.nodes_per_cell, corners, "cells of {nodes_per_cell} nodes have {corners} corners");
    let mut coords = mesh.coords.clone();
    let mut known = BTreeMap::new();
    let mut conn = Vec::new();
    for cell in mesh.cells() {
        conn.extend_from_slice(cell);
        for middle in &middles {
            let mut around: Vec<u32> = middle.iter().map(|&corner| cell[corner]).collect();
            around.sort_unstable();
            let number = *known.entry(around.clone()).or_insert_with(|| {
                let sum = |axis: usize| around.iter().map(|&node| mesh.coords[node as usize][axis]).sum::<f64>();
                coords.push(std::array::from_fn(|axis| sum(axis) / around.len() as f64));
                coords.len() as u32 - 1
            });
            conn.push(number);
        }
    }
    Mesh { coords, conn, nodes_per_cell }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{cuboid_hex8, cuboid_tet4};

    #[test]
    fn nodes_are_shared_between_cells() {
        let count = |mesh: Mesh<3>, nodes| second_order(&mesh, nodes).coords.len();
        // (2n + 1)³ nodes of a grid; without the middles of faces and cells (n + 1)³ + 3 n (n + 1)².
        assert_eq!(count(cuboid_hex8([0.0; 3], [1.0; 3], [2; 3]), 27), 125);
        assert_eq!(count(cuboid_hex8([0.0; 3], [1.0; 3], [2; 3]), 20), 27 + 54);
        assert_eq!(count(cuboid_tet4([0.0; 3], [1.0; 3], [2; 3]), 10), 125);
    }
}
