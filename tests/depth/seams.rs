//! Curved bodies that share their nodes at a seam: each has the faces that it would have alone.

use crate::depth;
use crate::scene::{Scene, distance, norm};
use fmc_shapes::{Mesh, cuboid_hex8, rectangle_quad4, second_order};
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

/// A mesh as two bodies, divided by where the first node of each cell lies; with nodes of their own, or shared at the seam.
fn divided<const D: usize>(mesh: &Mesh<D>, is_shared: bool, is_second: impl Fn(&[f64; D]) -> bool) -> Scene<D> {
    let mut scene = Scene::of(&[mesh]);
    scene.ids = mesh.cells().map(|cell| i64::from(is_second(&mesh.coords[cell[0] as usize]))).collect();
    assert_eq!(scene.surface().body_count(), 2);
    if !is_shared {
        let (ids, mut copies) = (scene.ids.clone(), BTreeMap::new());
        let nodes_per_cell = mesh.nodes_per_cell;
        let mut parted = mesh.clone();
        for (cell, _) in ids.iter().enumerate().filter(|(_, id)| **id == 1) {
            for node in &mut parted.conn[cell * nodes_per_cell..(cell + 1) * nodes_per_cell] {
                let next = parted.coords.len() as u32;
                let copy = *copies.entry(*node).or_insert(next);
                if copy == next {
                    parted.coords.push(mesh.coords[*node as usize]);
                }
                *node = copy;
            }
        }
        scene = Scene::of(&[&parted]);
        scene.ids = ids;
    }
    scene
}

/// A third body presses across the seam, and feels the same; the normals of faces around a node that bodies share are each body's own.
fn feels_the_same<const D: usize>(
    mesh: &Mesh<D>,
    punch: &Mesh<D>,
    smoothing: f64,
    is_second: impl Fn(&[f64; D]) -> bool + Copy,
) {
    let [shared, parted] = [true, false].map(|is_shared| {
        let scene = divided(mesh, is_shared, is_second).with(punch, 2);
        let mut contact = scene.contact(depth(1.0));
        contact.set_surface_smoothing(smoothing).expect("an angle");
        let found = contact.evaluate(&scene.coords).expect("valid coordinates");
        (found.energy, scene.nodes_of(1).map(|node| found.forces[node]).collect::<Vec<_>>())
    });
    assert!(parted.0 > 0.0 && (shared.0 / parted.0 - 1.0).abs() < 1e-12, "{} {}", shared.0, parted.0);
    let difference = distance(&shared.1, &parted.1) / norm(&parted.1);
    assert!(difference < 1e-12, "{difference}");
}

fn bent<const D: usize>(mut mesh: Mesh<D>) -> Mesh<D> {
    for x in &mut mesh.coords {
        let (angle, radius) = (FRAC_PI_2 * x[0], x[1]);
        (x[0], x[1]) = (radius * angle.sin(), radius * angle.cos());
    }
    mesh
}

#[test]
fn third_body_presses_on_a_curved_seam() {
    // x and y as angle and radius: more than 45° are the second body.
    let is_second = |x: f64, y: f64| x > y * 1.000_001;
    for nodes in [4, 8] {
        let [inner, outer] = [([0.5, 1.0], [8, 2]), ([0.995, 1.4], [9, 2])].map(|([from, to], cells)| {
            let straight = rectangle_quad4([0.0, from], [1.0, to], cells);
            bent(if nodes == 4 { straight } else { second_order(&straight, nodes) })
        });
        feels_the_same(&inner, &outer, if nodes == 4 { 30.0 } else { 0.0 }, |[x, y]| is_second(*x, *y));
    }
    for nodes in [8, 20] {
        let [inner, outer] = [([0.5, 1.0], [8, 2, 1]), ([0.995, 1.4], [9, 2, 1])].map(|([from, to], cells)| {
            let straight = cuboid_hex8([0.0, from, 0.0], [1.0, to, 0.5], cells);
            bent(if nodes == 8 { straight } else { second_order(&straight, nodes) })
        });
        feels_the_same(&inner, &outer, if nodes == 8 { 30.0 } else { 0.0 }, |[x, y, _]| is_second(*x, *y));
    }
}
