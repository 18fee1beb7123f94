//! Discs and balls with all nodes on the true surface, against closed forms.

use crate::scene::{Scene, exact};
use fmc_shapes::{Mesh, ball_tet4, disc_tri3, rectangle_quad4, second_order};
use std::f64::consts::PI;

/// Nodes in the middle of edges on the rim brought out to it.
fn on_rim<const D: usize>(straight: &Mesh<D>, nodes_per_cell: usize) -> Mesh<D> {
    let mut mesh = second_order(straight, nodes_per_cell);
    let norm = |x: &[f64; D]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
    let corners = straight.coords.len();
    let is_rim: Vec<bool> = mesh.coords.iter().map(|x| (norm(x) - 1.0).abs() < 1e-9).collect();
    let mut on_boundary = vec![false; mesh.coords.len()];
    let cell_type = Scene::of(&[&mesh]).blocks[0].0;
    let middles: &[[usize; 3]] = if D == 2 {
        &[[0, 1, 3], [1, 2, 4], [2, 0, 5]]
    } else {
        &[[0, 1, 4], [1, 2, 5], [2, 0, 6], [0, 3, 7], [1, 3, 8], [2, 3, 9]]
    };
    assert!(matches!(cell_type.node_count(), 6 | 10));
    for cell in mesh.conn.chunks_exact(nodes_per_cell) {
        for face in cell_type.faces().iter().filter(|face| face.iter().all(|&k| is_rim[cell[k] as usize])) {
            for [p, q, middle] in middles.iter().filter(|[p, q, _]| face.contains(p) && face.contains(q)) {
                assert!(is_rim[cell[*p] as usize] && is_rim[cell[*q] as usize]);
                on_boundary[cell[*middle] as usize] = true;
            }
        }
    }
    for (node, x) in mesh.coords.iter_mut().enumerate().skip(corners) {
        if on_boundary[node] {
            let size = norm(x);
            *x = x.map(|x| x / size);
        }
    }
    mesh
}

/// Rates at which errors fall between successive meshes of half the size.
fn rates(errors: &[f64]) -> Vec<f64> {
    errors.windows(2).map(|pair| (pair[0] / pair[1]).log2()).collect()
}

/// A disc inside a square: its area, and the resultant of a pressure that acts on one half of it.
#[test]
fn area_of_a_disc_is_of_fourth_order() {
    let mut errors = Vec::new();
    for edges in [16, 32, 64] {
        let disc = on_rim(&disc_tri3(1.0, edges), 6);
        let square = rectangle_quad4([-2.0, -2.0], [2.0, 2.0], [1, 1]);
        let found = Scene::of(&[&disc, &square]).evaluate(exact());
        errors.push((found.volume / PI - 1.0).abs());
    }
    let rates = rates(&errors);
    assert!(rates.iter().all(|rate| *rate > 3.5), "{errors:?}: {rates:?}");
}

#[test]
fn volume_of_a_ball_is_of_fourth_order() {
    let mut errors = Vec::new();
    for level in [1, 2, 3] {
        let ball = on_rim(&ball_tet4(1.0, level, 1 << (level - 1)), 10);
        let cube = fmc_shapes::cuboid_hex8([-2.0; 3], [2.0; 3], [1; 3]);
        let found = Scene::of(&[&ball, &cube]).evaluate(exact());
        errors.push((found.volume / (4.0 / 3.0 * PI) - 1.0).abs());
    }
    let rates = rates(&errors);
    assert!(rates.iter().all(|rate| *rate > 3.5), "{errors:?}: {rates:?}");
}
