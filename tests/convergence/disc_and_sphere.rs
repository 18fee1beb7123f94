//! The paper's first benchmarks (section 2.4): the area of a disc and the volume of a sphere of radius θ, and their
//! derivatives by θ, by lines through a body that lies in a larger one.

use crate::scene::{Scene, fibers};
use fmc_contact::{FiberOptions, Resolution};
use fmc_shapes::{Diagonals, cuboid_surface, disc_tri3, icosphere, rectangle_tri3};
use std::f64::consts::PI;

/// A tenth of the paper's 300 000.
const FIBERS: usize = 30_000;

/// Largest relative error over some seeds of V, and of dV/dθ = Σ ∂V/∂x · x/θ at θ = 1.
fn largest_errors<const D: usize>(scene: &Scene<D>, value: f64, derivative: f64) -> [f64; 2] {
    let mut largest = [0.0f64; 2];
    for seed in 0..5 {
        // The lines that miss count as well: the count asked for is a little below the limit.
        let resolution = Resolution::Count(FIBERS * 9 / 10);
        let contact = scene.evaluate(fibers(FiberOptions { resolution, seed, ..FiberOptions::default() }));
        assert!(contact.fiber_count <= FIBERS, "{} fibers", contact.fiber_count);
        let nodes = scene.nodes_of(0);
        let slope: f64 = (nodes.clone().map(|n| &contact.forces[n]).zip(&scene.coords[nodes]))
            .map(|(force, x)| -(0..D).map(|i| force[i] * x[i]).sum::<f64>())
            .sum();
        largest[0] = largest[0].max((contact.volume / value - 1.0).abs());
        largest[1] = largest[1].max((slope / derivative - 1.0).abs());
    }
    largest
}

/// The paper states 0.036 % and 0.322 %. The polygon of 400 edges is itself 0.004 % small.
#[test]
fn disc_and_its_derivative() {
    let block = rectangle_tri3([-2.0; 2], [2.0; 2], [4, 4], Diagonals::Same);
    let errors = largest_errors(&Scene::of(&[&disc_tri3(1.0, 400), &block]), PI, 2.0 * PI);
    println!("disc: value {:.4} %, derivative {:.4} %", 100.0 * errors[0], 100.0 * errors[1]);
    assert!(errors[0] < 0.036e-2 && errors[1] < 0.322e-2, "{errors:?}");
}

/// The paper states 0.039 % and 0.225 %. The icosphere of 81 920 triangles is itself 0.014 % small.
#[test]
fn sphere_and_its_derivative() {
    let sphere = icosphere(1.0, 6).rotated([0.3, 0.5, 0.8], 0.4);
    let block = cuboid_surface([-2.0; 3], [2.0; 3], [2; 3]);
    let errors = largest_errors(&Scene::of(&[&sphere, &block]), 4.0 / 3.0 * PI, 4.0 * PI);
    println!("sphere: value {:.4} %, derivative {:.4} %", 100.0 * errors[0], 100.0 * errors[1]);
    assert!(errors[0] < 0.039e-2 && errors[1] < 0.225e-2, "{errors:?}");
}
