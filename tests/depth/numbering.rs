//! The depth of a body does not depend on how its nodes are numbered, nor in which order a cell has them.

use crate::depth;
use crate::scene::{Scene, distance, norm};
use fmc_shapes::{Diagonals, Mesh, Splitmix, cuboid_tet4, rectangle_tri3};

/// Energy and the largest difference of forces that a small block inside a body has with two descriptions of the body;
/// `new_number` has the number in the second of every node of the first.
fn same<const D: usize>(first: &Mesh<D>, second: &Mesh<D>, new_number: impl Fn(usize) -> usize, probe: &Mesh<D>) {
    let [one, other] = [first, second].map(|body| Scene::of(&[body, probe]).evaluate(depth(1.0)));
    assert!(one.energy > 0.0 && (other.energy / one.energy - 1.0).abs() < 1e-12, "{} {}", one.energy, other.energy);
    let moved: Vec<[f64; D]> = (0..first.coords.len()).map(|n| other.forces[new_number(n)]).collect();
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

/// Coarse bodies whose cells have all their corners on the surface, with nodes that are moved at random, deep in one another: nodes have the
/// reverse numbers, and cells begin with another corner.
#[test]
fn which_corner_of_a_coarse_cell_comes_first() {
    let mut random = Splitmix::new(11);
    for cells in [1, 2] {
        let mut body = rectangle_tri3([0.0, 0.0], [1.0, 0.8], [2, cells], Diagonals::Same);
        shake(&mut body, &mut random);
        turned(&body, |k| [1, 2, 0][k], &rectangle_tri3([0.2, 0.3], [0.9, 1.2], [2, 1], Diagonals::Same));
        let mut body = cuboid_tet4([0.0; 3], [1.0, 0.8, 0.9], [2, cells, cells]);
        shake(&mut body, &mut random);
        // An even permutation, which leaves the sign of the volume.
        turned(&body, |k| [1, 2, 0, 3][k], &cuboid_tet4([0.2, 0.1, 0.3], [0.9, 0.7, 1.3], [1, 2, 1]));
    }
}

fn shake<const D: usize>(body: &mut Mesh<D>, random: &mut Splitmix) {
    body.coords.as_flattened_mut().iter_mut().for_each(|x| *x += random.between(-0.05, 0.05));
}

fn turned<const D: usize>(body: &Mesh<D>, corner: impl Fn(usize) -> usize, probe: &Mesh<D>) {
    let last = body.coords.len() - 1;
    let mut other = body.clone();
    other.coords.reverse();
    for (cell, of_body) in other.conn.chunks_mut(D + 1).zip(body.conn.chunks(D + 1)) {
        (0..=D).for_each(|k| cell[k] = last as u32 - of_body[corner(k)]);
    }
    same(body, &other, |n| last - n, probe);
}
