//! Meshes whose nodes were not merged, or in which a flat cell was left out: told with the nodes and the area.

use crate::scene::Scene;
use fmc_contact::{EnergyLaw, Options, Warning, overlap::Partner};
use fmc_shapes::{Mesh, cuboid_hex8, rectangle_quad4};

/// The same cells, each with nodes of its own.
fn soup<const D: usize>(mesh: &Mesh<D>) -> Mesh<D> {
    let coords = mesh.conn.iter().map(|&node| mesh.coords[node as usize]).collect();
    Mesh { coords, conn: (0..mesh.conn.len() as u32).collect(), nodes_per_cell: mesh.nodes_per_cell }
}

fn torn<const D: usize>(scene: &Scene<D>) -> Vec<Warning> {
    let found = scene.evaluate(Options::new(EnergyLaw::depth(1.0))).warnings;
    found.into_iter().filter(|warning| matches!(warning, Warning::CoincidingFaces { .. })).collect()
}

#[test]
fn nodes_that_were_not_merged() {
    let lower = rectangle_quad4([0.0, 0.0], [1.0, 1.0], [4, 4]);
    let upper = rectangle_quad4([0.13, 0.99], [0.91, 2.0], [5, 4]);
    assert_eq!(torn(&Scene::of(&[&lower, &upper])), []);
    let scene = Scene::of(&[&soup(&lower), &upper]);
    let found = torn(&scene);
    let [Warning::CoincidingFaces { body: Partner::Body(0), area, nodes }] = &found[..] else { panic!("{found:?}") };
    // 24 inner edges of a quarter; all nodes of 16 cells but those at the four corners of the square.
    assert!((area - 6.0).abs() < 1e-12, "{area}");
    assert_eq!(nodes.len(), 64 - 4);
    assert!(nodes.iter().all(|&node| scene.nodes_of(0).contains(&node)));
    let text = found[0].clone().counted_from(1).to_string();
    assert!(text.contains("area of 6.000e0") && text.contains("60 in all: 2, 3, 4, 5"), "{text}");
    // Coordinates with seven digits.
    let mut rounded = scene;
    rounded.coords.iter_mut().for_each(|x| *x = x.map(|x| f64::from((x / 3.0) as f32) * 3.0));
    assert_eq!(torn(&rounded).len(), 1);
}

#[test]
fn in_space_one_seam() {
    let [left, right, upper] = [
        cuboid_hex8([0.0; 3], [0.5, 1.0, 1.0], [2, 3, 2]),
        cuboid_hex8([0.5, 0.0, 0.0], [1.0, 1.0, 1.0], [2, 2, 5]),
        cuboid_hex8([0.2, 0.2, 0.99], [0.8, 0.8, 2.0], [2, 2, 2]),
    ];
    // One body of two grids that do not match; then two bodies, which may touch.
    let found = torn(&Scene::new().with(&left, 0).with(&right, 0).with(&upper, 1));
    let [Warning::CoincidingFaces { body: Partner::Body(0), area, .. }] = &found[..] else { panic!("{found:?}") };
    assert!((area - 1.0).abs() < 1e-9, "{area}");
    assert_eq!(torn(&Scene::new().with(&left, 0).with(&right, 1).with(&upper, 2)), []);
}
