//! Disc of radius θ, inside a larger block: A = πθ², dA/dθ = 2πθ.

use super::bounds::PAPER_2D;
use super::case::{Case, Form};
use super::closed_form::ClosedForm;
use super::closed_form::polygon_fraction;
use super::scene::{PoseRate, Scene};
use fmc_contact::{Pose, Shape};
use fmc_shapes::{Mesh, disc_tri3, rectangle_quad4};
use std::f64::consts::PI;

/// Edges around the disc: its polygon is 4e-5 smaller than the circle, a ninth of the paper's largest error.
const EDGES: usize = 400;

/// The case.
pub(super) fn disc() -> Case<2> {
    Case {
        name: "disc",
        title: "Disc of radius θ",
        thetas: vec![1.0],
        range: [0.5, 1.5],
        closed_form: area,
        bounds: PAPER_2D,
        fiber_length: 0.5,
        forms: vec![
            Form {
                name: "mesh",
                scene: |theta| {
                    let growth = move |x: [f64; 2]| x.map(|x| x / theta);
                    Scene::of(&disc_tri3(theta, EDGES), growth).with(&block(theta), |_| [0.0; 2])
                },
                of_the_mesh: Some(|theta| area(theta).times(polygon_fraction(EDGES))),
                straight: true,
            },
            Form {
                name: "shape",
                scene: |theta| {
                    let growth = PoseRate { scale: 1.0, ..PoseRate::STILL };
                    Scene::of(&block(theta), |_| [0.0; 2]).with_shape(
                        Shape::Ball { radius: 1.0 },
                        Pose::at([0.0; 2]).scaled(theta),
                        growth,
                    )
                },
                of_the_mesh: None,
                straight: false,
            },
        ],
    }
}

fn area(theta: f64) -> ClosedForm {
    ClosedForm::one_way(PI * theta * theta, 2.0 * PI * theta)
}

fn block(theta: f64) -> Mesh<2> {
    rectangle_quad4([-1.5 * theta; 2], [1.4 * theta; 2], [5, 4])
}
