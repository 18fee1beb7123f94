//! Patch test: a uniform pressure over a flat interface of meshes that do not match loads every node by its share of the
//! faces about it.

use crate::scene::{Scene, exact, table::exactly};
use crate::{boxes, pair};
use fmc_contact::{EnergyLaw, Options};
use fmc_shapes::Mesh;

/// Integrals of the shape functions over the faces at this height.
fn shares(body: &[Mesh<3>], height: f64) -> Vec<f64> {
    let mut shares = vec![0.0; body[0].coords.len()];
    for mesh in body {
        let faces: Vec<Vec<u32>> = mesh.boundary_faces();
        for face in faces {
            let x: Vec<[f64; 3]> = face.iter().map(|&n| mesh.coords[n as usize]).collect();
            if x.iter().all(|x| (x[2] - height).abs() < 1e-12) {
                let twice: f64 =
                    (0..x.len()).map(|k| (x[k], x[(k + 1) % x.len()])).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum();
                face.iter().for_each(|&n| shares[n as usize] += 0.5 * twice.abs() / face.len() as f64);
            }
        }
    }
    shares
}

/// Forces across the interface: those of the upper body have a closed form, those of the lower carry the same load.
fn is_uniform(lower: &[Mesh<3>], upper: &[Mesh<3>], delta: f64, options: Options, pressure: f64, what: &str) {
    let scene: Scene<3> = pair(lower, upper);
    let contact = scene.evaluate(options);
    let expected = shares(upper, -delta);
    for (node, share) in scene.nodes_of(1).zip(&expected) {
        let found = contact.forces[node][2];
        assert!((found - pressure * share).abs() < 1e-9 * pressure, "{what}: {found} for {}", pressure * share);
    }
    // Linear functions over the interface are told by the lower nodes: the load, and where it acts.
    let below = |f: fn(&[f64; 3]) -> f64| -> f64 {
        scene.nodes_of(0).map(|node| -contact.forces[node][2] * f(&scene.coords[node])).sum()
    };
    assert!((below(|_| 1.0) - pressure).abs() < 1e-9 * pressure, "{what}");
    for along in [below(|x| x[0]), below(|x| x[1])] {
        assert!((along - 0.5 * pressure).abs() < 1e-9 * pressure, "{what}: {along}");
    }
}

/// Of every type on every other: the pressure of the volume law is k, that of the law on lines k δ.
#[test]
fn uniform_pressure() {
    let delta = 1e-3;
    let lower = boxes([-0.5, -0.5, -1.0], [1.5, 1.5, 0.0], [3, 3, 3]);
    let upper = boxes([0.0, 0.0, -delta], [1.0, 1.0, 1.0 - delta], [2, 2, 3]);
    for (i, below) in lower.iter().enumerate() {
        for (j, above) in upper.iter().enumerate() {
            let what = format!("{j} on {i}");
            is_uniform(below, above, delta, exact(), 1.0, &what);
            is_uniform(below, above, delta, exactly(EnergyLaw::fiber(4.0)), 4.0 * delta, &what);
        }
    }
}
