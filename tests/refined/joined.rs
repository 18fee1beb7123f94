//! What is surface: bodies stay whole, and no inner face is taken for boundary.

use crate::{boxes, rectangles, refined, surface, triangles};
use fmc_contact::Error;
use fmc_shapes::{cuboid_hex8, rectangle_quad4};

fn on_box<const D: usize>(x: &[f64; D]) -> bool {
    x.iter().any(|x| *x == 0.0 || *x == 1.0)
}

fn is_whole<const D: usize>(mesh: &fmc_shapes::Mesh<D>) {
    let surface = surface(mesh).expect("a mesh refined in part");
    assert_eq!(surface.body_count(), 1);
    let mut measure = 0.0;
    for (_, face) in surface.faces() {
        let corners: Vec<[f64; D]> = face.iter().map(|&node| mesh.coords[node as usize]).collect();
        let middle: [f64; D] =
            std::array::from_fn(|i| corners.iter().map(|x| x[i]).sum::<f64>() / corners.len() as f64);
        assert!(on_box(&middle), "a face within: {corners:?}");
        let side = |k: usize| -> f64 { (0..D).map(|i| (corners[k][i] - corners[0][i]).powi(2)).sum::<f64>().sqrt() };
        measure += match corners.len() {
            2 => side(1),
            3 => 0.5 * [side(1), side(2)].into_iter().fold(f64::INFINITY, f64::min).powi(2),
            _ => side(1) * side(3),
        };
    }
    // Right-angled triangles of two equal sides have half their square.
    assert!((measure - 2.0 * D as f64).abs() < 1e-12 || mesh.nodes_per_cell == 4 && D == 3, "{measure}");
}

#[test]
fn one_body_with_its_own_surface() {
    rectangles([0.0; 2], [1.0; 2], [4, 4]).iter().for_each(is_whole);
    boxes([0.0; 3], [1.0; 3], [3, 3, 3]).iter().for_each(is_whole);
}

/// A node that hangs beside the middle is refused, and both cells are named.
#[test]
fn a_node_beside_the_middle() {
    let mut mesh = refined(&rectangle_quad4([0.0; 2], [1.0; 2], [2, 1]), |cell| cell == 0);
    let hanging = mesh.coords.iter().position(|x| *x == [0.5, 0.5]).expect("a node");
    mesh.coords[hanging][0] += 1e-4;
    let refused = surface(&mesh).err();
    assert!(matches!(refused, Some(Error::NonConforming { cells: [_, 4] })), "{refused:?}");
}

/// Halves of a face: a layer of hexahedra that is divided along one axis alone.
#[test]
fn halves() {
    let mut mesh = cuboid_hex8([0.0; 3], [1.0; 3], [1, 1, 2]);
    // The upper cell, 4 to 11, in two along x.
    let middle = |p: [f64; 3], q: [f64; 3]| std::array::from_fn(|i| 0.5 * (p[i] + q[i]));
    let cell: Vec<u32> = mesh.conn[8..16].to_vec();
    let mut edge = |p: usize, q: usize| {
        mesh.coords.push(middle(mesh.coords[cell[p] as usize], mesh.coords[cell[q] as usize]));
        mesh.coords.len() as u32 - 1
    };
    let [a, b, c, d] = [edge(0, 1), edge(3, 2), edge(7, 6), edge(4, 5)];
    mesh.conn.truncate(8);
    mesh.conn.extend([cell[0], a, b, cell[3], cell[4], d, c, cell[7]]);
    mesh.conn.extend([a, cell[1], cell[2], b, d, cell[5], cell[6], c]);
    let found = surface(&mesh).expect("halves");
    assert_eq!((found.body_count(), found.faces().len()), (1, 5 + 4 + 4));
}

/// A slit of one missing cell stays a hole.
#[test]
fn a_missing_cell_is_a_hole() {
    let mut mesh = triangles([0.0; 2], [1.0; 2], [4, 4]);
    let without: Vec<u32> = mesh.cells().enumerate().filter(|(k, _)| *k != 13).flat_map(|(_, c)| c.to_vec()).collect();
    mesh.conn = without;
    assert_eq!(surface(&mesh).expect("a hole").faces().len(), 16 + 3);
}
