//! Ball of radius θ, inside a larger block: V = 4/3 πθ³, dV/dθ = 4πθ².

use super::bounds::PAPER_3D;
use super::case::{Case, Form};
use super::closed_form::ClosedForm;
use super::scene::{PoseRate, Scene};
use fmc_contact::{Pose, Shape};
use fmc_shapes::{Mesh, ball_tet4, cuboid_hex8, icosphere};
use std::f64::consts::PI;

/// 81 920 triangles: their polyhedron is 1.3e-4 smaller than the ball, a third of the paper's largest error.
const LEVEL: usize = 6;

/// The case.
pub(super) fn sphere() -> Case<3> {
    Case {
        name: "sphere",
        title: "Sphere of radius θ",
        thetas: vec![1.0],
        range: [0.5, 1.5],
        closed_form: |theta| ClosedForm::one_way(4.0 / 3.0 * PI * theta.powi(3), 4.0 * PI * theta * theta),
        bounds: PAPER_3D,
        fiber_length: 0.5,
        forms: vec![
            Form {
                name: "mesh",
                scene: |theta| {
                    let growth = move |x: [f64; 3]| x.map(|x| x / theta);
                    Scene::of(&ball_tet4(theta, LEVEL, 1), growth).with(&block(theta), |_| [0.0; 3])
                },
                of_the_mesh: Some(|theta| {
                    let value = icosphere(theta, LEVEL).measure();
                    ClosedForm::one_way(value, 3.0 * value / theta)
                }),
                straight: true,
            },
            Form {
                name: "shape",
                scene: |theta| {
                    let growth = PoseRate { scale: 1.0, ..PoseRate::STILL };
                    Scene::of(&block(theta), |_| [0.0; 3]).with_shape(
                        Shape::Ball { radius: 1.0 },
                        Pose::at([0.0; 3]).scaled(theta),
                        growth,
                    )
                },
                of_the_mesh: None,
                straight: false,
            },
        ],
    }
}

fn block(theta: f64) -> Mesh<3> {
    cuboid_hex8([-1.5 * theta; 3], [1.4 * theta; 3], [5, 4, 3])
}
