//! Unit cube turned by θ about the z axis through its centre, inside a larger block: V = 1, dV/dθ = 0.
//!
//! The flux ∫ |v·n| dA, by which the error of the derivative is measured, is 1: on each of four sides of length 1, |v·n|
//! is the distance from the middle.

use super::bounds::DRAWN;
use super::case::{Case, Form};
use super::closed_form::ClosedForm;
use super::scene::{PoseRate, Scene};
use fmc_contact::{Pose, Shape};
use fmc_shapes::{Mesh, cuboid_hex8};
use std::f64::consts::FRAC_PI_4;

pub(super) const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// Velocity of a point per radian about z.
pub(super) fn turning(x: [f64; 3]) -> [f64; 3] {
    [-x[1], x[0], 0.0]
}

/// The cube turned by θ.
pub(super) fn turned_cube(theta: f64) -> Mesh<3> {
    cuboid_hex8([-0.5; 3], [0.5; 3], [4; 3]).rotated(Z, theta)
}

/// The case.
pub(super) fn cube() -> Case<3> {
    Case {
        name: "cube",
        title: "Unit cube turned by θ about z",
        thetas: vec![0.0, 0.2, 0.4, 0.6, FRAC_PI_4, 1.0, 1.2, 1.4],
        range: [0.0, 2.0 * FRAC_PI_4],
        closed_form: |_| ClosedForm { value: 1.0, derivative: 0.0, flux: 1.0 },
        bounds: DRAWN,
        fiber_length: 0.25,
        forms: vec![
            Form {
                name: "mesh",
                scene: |theta| Scene::of(&turned_cube(theta), turning).with(&block(), |_| [0.0; 3]),
                of_the_mesh: None,
                straight: true,
            },
            Form {
                name: "shape",
                scene: |theta| {
                    let shape = Shape::Cuboid { half_extents: [0.5; 3] };
                    let rate = PoseRate { rotation: Z, ..PoseRate::STILL };
                    Scene::of(&block(), |_| [0.0; 3]).with_shape(shape, Pose::at([0.0; 3]).turned_about(Z, theta), rate)
                },
                of_the_mesh: None,
                straight: true,
            },
        ],
    }
}

fn block() -> Mesh<3> {
    cuboid_hex8([-1.0; 3], [1.1; 3], [3, 4, 3])
}
