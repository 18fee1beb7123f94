//! Cone with its apex up, moved along z through a fixed unit cube on z = 0, which its apex enters at θ = 0.
//!
//! With base radius R, height H and s = R/H the section at height z has the radius s(θ − z), so that
//!
//! ```text
//!     V = π s²/3 (min(θ, H)³ − max(0, θ − 1)³)      apex at z = θ, base at z = θ − H
//! ```
//!
//! The paper does not print its sizes; these are ours.

use super::bounds::DRAWN;
use super::case::{Case, Form};
use super::closed_form::ClosedForm;
use super::closed_form::polygon_fraction;
use super::scene::{PoseRate, Scene};
use fmc_contact::{Pose, Shape};
use fmc_shapes::{Mesh, cone_tet4, cuboid_hex8};
use std::f64::consts::PI;

const RADIUS: f64 = 0.45;
const HEIGHT: f64 = 1.5;

/// Edges around the cone: its sections are 1e-4 smaller than discs.
const EDGES: usize = 256;

/// The case.
pub(super) fn cone() -> Case<3> {
    Case {
        name: "cone",
        title: "Unit cube and a cone moved along z by θ",
        thetas: vec![0.25, 0.5, 0.75, 0.95, 1.1, 1.25, 1.4, 1.6, 1.8, 2.0],
        range: [0.05, 2.2],
        closed_form: volume,
        bounds: DRAWN,
        fiber_length: 0.2,
        forms: vec![
            Form {
                name: "mesh",
                scene: |theta| {
                    let body = cone_tet4(RADIUS, HEIGHT, EDGES, 1).translated([0.0, 0.0, theta - HEIGHT]);
                    Scene::of(&body, |_| [0.0, 0.0, 1.0]).with(&cube(), |_| [0.0; 3])
                },
                of_the_mesh: Some(|theta| volume(theta).times(polygon_fraction(EDGES))),
                straight: true,
            },
            Form {
                name: "shape",
                scene: |theta| {
                    let shape = Shape::Cone { radius: RADIUS, half_height: 0.5 * HEIGHT };
                    let pose = Pose::at([0.0, 0.0, theta - 0.5 * HEIGHT]);
                    let rate = PoseRate { position: [0.0, 0.0, 1.0], ..PoseRate::STILL };
                    Scene::of(&cube(), |_| [0.0; 3]).with_shape(shape, pose, rate)
                },
                of_the_mesh: None,
                straight: false,
            },
        ],
    }
}

fn volume(theta: f64) -> ClosedForm {
    let factor = PI * (RADIUS / HEIGHT).powi(2);
    let (entered, left) = (theta.min(HEIGHT), (theta - 1.0).max(0.0));
    // The flank moves outwards; the base, once inside, inwards.
    let flank = factor * (entered * entered - left * left);
    let base = if theta > HEIGHT { factor * HEIGHT * HEIGHT } else { 0.0 };
    let value = factor / 3.0 * (entered.powi(3) - left.powi(3));
    ClosedForm { value, derivative: flank - base, flux: flank + base }
}

fn cube() -> Mesh<3> {
    cuboid_hex8([-0.5, -0.5, 0.0], [0.5, 0.5, 1.0], [4; 3])
}
