//! The turning cube over a second, fixed one: the overlap of a turned with a shifted square, by clipping, times a height.

use super::bounds::DRAWN;
use super::case::{Case, Form};
use super::clip::clip;
use super::closed_form::ClosedForm;
use super::cube::{Z, turned_cube, turning};
use super::scene::{PoseRate, Scene};
use fmc_contact::{Pose, Shape};
use fmc_shapes::{Mesh, cuboid_hex8};
use std::f64::consts::FRAC_PI_4;

/// Lowest corner of the fixed unit cube: off the turning one's centre, so that the overlap changes with the angle.
const CORNER: [f64; 3] = [0.2, 0.1, 0.1];

/// The case.
pub(super) fn cubes() -> Case<3> {
    Case {
        name: "cubes",
        title: "Unit cube turned by θ about z over a fixed one",
        thetas: vec![0.1, 0.25, 0.4, 0.55, 0.7, FRAC_PI_4, 1.0, 1.15, 1.3, 1.45],
        range: [0.0, 2.0 * FRAC_PI_4],
        closed_form: overlap,
        bounds: DRAWN,
        fiber_length: 0.15,
        forms: vec![
            Form {
                name: "mesh",
                scene: |theta| Scene::of(&turned_cube(theta), turning).with(&fixed(), |_| [0.0; 3]),
                of_the_mesh: None,
                straight: true,
            },
            Form {
                name: "shape",
                scene: |theta| {
                    let shape = Shape::Cuboid { half_extents: [0.5; 3] };
                    let rate = PoseRate { rotation: Z, ..PoseRate::STILL };
                    Scene::of(&fixed(), |_| [0.0; 3]).with_shape(shape, Pose::at([0.0; 3]).turned_about(Z, theta), rate)
                },
                of_the_mesh: None,
                straight: true,
            },
        ],
    }
}

fn overlap(theta: f64) -> ClosedForm {
    let (s, c) = theta.sin_cos();
    let turned = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]].map(|[x, y]| [c * x - s * y, s * x + c * y]);
    let [x, y, z] = CORNER;
    let square = [[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]];
    clip(&turned, |[x, y]| [-y, x], &square).times(0.5 - z)
}

fn fixed() -> Mesh<3> {
    cuboid_hex8(CORNER, CORNER.map(|x| x + 1.0), [3; 3])
}
