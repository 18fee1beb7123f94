//! The depth of a body does not depend on how its nodes are numbered, nor in which order a cell has them.

use crate::depth;
use crate::scene::{Scene, distance, norm};
use fmc_shapes::{Diagonals, Mesh, rectangle_tri3};

/// Energy and the largest difference of forces that a small block inside a body has with two descriptions of the body;
/// `new_number` has the number in the second of every node of the first.
fn same(first: &Mesh<2>, second: &Mesh<2>, new_number: impl Fn(usize) -> usize, probe: &Mesh<2>) {
    let [one, other] = [first, second].map(|body| Scene::of(&[body, probe]).evaluate(depth(1.0)));
    assert!(one.energy > 0.0 && (other.energy / one.energy - 1.0).abs() < 1e-12, "{} {}", one.energy, other.energy);
    let moved: Vec<[f64; 2]> = (0..first.coords.len()).map(|n| other.forces[new_number(n)]).collect();
    let off = distance(&one.forces[..first.coords.len()], &moved);
    assert!(off < 1e-12 * norm(&one.forces), "{off}");
}

/// An edge from the bottom to the top of a plate has a point in its middle, whose depth is half the height of the plate, though a
/// node of the cell inside the plate lies nearer to that point.
#[test]
fn which_node_of_a_cell_comes_first() {
    let coords = vec![[-1.0, 0.0], [0.5, 0.0], [2.0, 0.0], [-1.0, 1.0], [0.5, 1.0], [2.0, 1.0], [0.7, 0.5], [0.3, 0.5]];
    let cells: [[u32; 3]; 8] = [[6, 4, 1], [6, 1, 2], [6, 2, 5], [6, 5, 4], [7, 1, 4], [7, 0, 1], [7, 3, 0], [7, 4, 3]];
    let from = |shift: usize| Mesh {
        coords: coords.clone(),
        conn: cells.iter().flat_map(|cell| (0..3).map(|k| cell[(k + shift) % 3])).collect(),
        nodes_per_cell: 3,
    };
    let probe = rectangle_tri3([0.43, 0.42], [0.58, 0.6], [2, 2], Diagonals::Same);
    same(&from(0), &from(1), |n| n, &probe);
    same(&from(0), &from(2), |n| n, &probe);
}

/// A node that hangs between another that hangs and one that does not, with each of the two hanging ones the first.
#[test]
fn which_of_two_hanging_nodes_comes_first() {
    let mut coords = vec![
        [0.0, 0.0],
        [4.0, 0.0],
        [4.0, 3.0],
        [0.0, 3.0],
        [0.5, 1.0],
        [2.0, 1.0],
        [1.25, 2.0],
        [1.25, 0.0],
        [1.25, 1.0],
        [1.25, 1.5],
    ];
    let [d, e, b, f, a, c] = [4, 5, 6, 7, 8, 9];
    let cells = [
        [f, e, d],
        [0, f, d],
        [f, 1, e],
        [0, d, 3],
        [3, d, b],
        [3, b, 2],
        [b, e, 2],
        [e, 1, 2],
        [a, e, b],
        [d, a, c],
        [d, c, b],
    ];
    let first = Mesh { coords: coords.clone(), conn: cells.concat(), nodes_per_cell: 3 };
    coords.reverse();
    let last = first.coords.len() - 1;
    let conn = first.conn.iter().map(|n| last as u32 - n).collect();
    let second = Mesh { coords, conn, nodes_per_cell: 3 };
    let probe = rectangle_tri3([1.05, 1.35], [1.45, 1.7], [2, 2], Diagonals::Same);
    same(&first, &second, |n| last - n, &probe);
}
