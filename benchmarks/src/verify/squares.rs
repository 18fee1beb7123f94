//! Two unit squares that start corner to corner at the origin and move by (θ, θ) and (−θ, −θ).
//!
//! A = (2θ)² until they coincide at θ = ½, then (2 − 2θ)².

use super::bounds::DRAWN;
use super::case::{Case, Form};
use super::closed_form::ClosedForm;
use super::scene::{PoseRate, Scene};
use fmc_contact::{Pose, Shape};
use fmc_shapes::{Mesh, rectangle_quad4};

/// The case.
pub(super) fn squares() -> Case<2> {
    Case {
        name: "squares",
        title: "Two unit squares moved by (±θ, ±θ)",
        thetas: vec![0.1, 0.2, 0.25, 0.3, 0.4, 0.6, 0.7, 0.75, 0.8, 0.9],
        range: [0.02, 0.98],
        closed_form: |theta| {
            let (side, rate) = if theta < 0.5 { (2.0 * theta, 2.0) } else { (2.0 - 2.0 * theta, -2.0) };
            ClosedForm::one_way(side * side, 2.0 * side * rate)
        },
        bounds: DRAWN,
        fiber_length: 0.1,
        forms: vec![
            Form {
                name: "mesh",
                scene: |theta| {
                    let other = rectangle_quad4([-theta; 2], [1.0 - theta; 2], [6, 6]);
                    Scene::of(&lower(theta), |_| [1.0; 2]).with(&other, |_| [-1.0; 2])
                },
                of_the_mesh: None,
                straight: true,
            },
            Form {
                name: "shape",
                scene: |theta| {
                    let rate = PoseRate { position: [-1.0; 2], ..PoseRate::STILL };
                    let shape = Shape::Cuboid { half_extents: [0.5; 2] };
                    Scene::of(&lower(theta), |_| [1.0; 2]).with_shape(shape, Pose::at([0.5 - theta; 2]), rate)
                },
                of_the_mesh: None,
                straight: true,
            },
        ],
    }
}

fn lower(theta: f64) -> Mesh<2> {
    rectangle_quad4([theta - 1.0; 2], [theta; 2], [8, 8])
}
