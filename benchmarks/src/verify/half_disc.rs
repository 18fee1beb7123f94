//! Half-disc of radius θ, flat side up, its centre at the height h over a block, into which it grows.
//!
//! ```text
//!      ______________  y = h          A     = θ² acos(h/θ) − h √(θ² − h²)
//!      \            /                 dA/dθ = 2θ acos(h/θ)
//!    ___\__________/___  y = 0
//!   |    '-.____.-'    |              both are those of the circle's segment below y = 0
//! ```
//!
//! The paper does not print its sizes; these are ours. As an implicit shape it is a disc: the upper half meets nothing.

use super::bounds::DRAWN;
use super::case::{Case, Form};
use super::clip::clip;
use super::closed_form::ClosedForm;
use super::scene::{PoseRate, Scene};
use fmc_contact::{Pose, Shape};
use fmc_shapes::{Mesh, half_disc_tri3, rectangle_quad4};
use std::f64::consts::PI;

const CENTRE: [f64; 2] = [0.0, 0.5];
const BLOCK: [[f64; 2]; 2] = [[-1.5, -1.0], [1.5, 0.0]];

/// Edges of the arc: at the smallest θ below, the polygon's segment is 7e-5 smaller than the circle's.
const EDGES: usize = 320;

/// The case.
pub(super) fn half_disc() -> Case<2> {
    Case {
        name: "half-disc",
        title: "Half-disc of radius θ over a block",
        thetas: vec![0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4],
        range: [0.55, 1.45],
        closed_form: segment,
        bounds: DRAWN,
        fiber_length: 0.2,
        forms: vec![
            Form {
                name: "mesh",
                scene: |theta| {
                    let body = half_disc_tri3(theta, EDGES).rotated(PI).translated(CENTRE);
                    Scene::of(&body, growth(theta)).with(&block(), |_| [0.0; 2])
                },
                of_the_mesh: Some(|theta| {
                    let [[left, bottom], [right, top]] = BLOCK;
                    let corner = |k| {
                        let (s, c) = (PI * k as f64 / EDGES as f64).sin_cos();
                        [CENTRE[0] - theta * c, CENTRE[1] - theta * s]
                    };
                    let polygon: Vec<_> = (0..=EDGES).map(corner).collect();
                    clip(&polygon, growth(theta), &[[left, bottom], [right, bottom], [right, top], [left, top]])
                }),
                straight: true,
            },
            Form {
                name: "shape",
                scene: |theta| {
                    let rate = PoseRate { scale: 1.0, ..PoseRate::STILL };
                    let pose = Pose::at(CENTRE).scaled(theta);
                    Scene::of(&block(), |_| [0.0; 2]).with_shape(Shape::Ball { radius: 1.0 }, pose, rate)
                },
                of_the_mesh: None,
                straight: false,
            },
        ],
    }
}

fn segment(theta: f64) -> ClosedForm {
    let h = CENTRE[1];
    let half_angle = (h / theta).acos();
    let area = theta * theta * half_angle - h * (theta * theta - h * h).sqrt();
    ClosedForm::one_way(area, 2.0 * theta * half_angle)
}

fn growth(theta: f64) -> impl Fn([f64; 2]) -> [f64; 2] {
    move |x| [(x[0] - CENTRE[0]) / theta, (x[1] - CENTRE[1]) / theta]
}

fn block() -> Mesh<2> {
    rectangle_quad4(BLOCK[0], BLOCK[1], [30, 10])
}
