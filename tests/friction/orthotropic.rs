//! Friction with another coefficient across a direction: a surface with machining marks, or fibres.

mod alike;
mod carried;
mod closed_form;
mod told;

use crate::scene::Scene;
use fmc_contact::contact::{OrthotropicFriction, PairOptions, PointOfContact};
use fmc_contact::overlap::Partner;
use fmc_contact::{Contact, Obstacle, Options, Pose, Shape};
use fmc_shapes::cuboid_hex8;

const DELTA: f64 = 1e-3;
const MU: [f64; 2] = [0.5, 0.2];
/// Neither along an axis nor in the plane of a face.
const DIRECTION: [f64; 3] = [0.8, -0.5, 0.3];
const BODIES: [Partner; 2] = [Partner::Body(0), Partner::Body(1)];
const ON_FLOOR: [Partner; 2] = [Partner::Body(0), Partner::Obstacle(0)];

fn across(direction: [f64; 3]) -> OrthotropicFriction {
    OrthotropicFriction::new(MU[1], direction)
}

fn own(friction: OrthotropicFriction) -> Option<PairOptions> {
    Some(PairOptions::with_orthotropic_friction(MU[0], friction))
}

/// A block on a plane, whose faces there are `DELTA` deep.
fn on_floor(options: Options, pair: Option<PairOptions>) -> (Scene<3>, Contact<3>) {
    let scene = Scene::of(&[&cuboid_hex8([-0.5, -0.4, -DELTA], [0.5, 0.4, 0.7], [2, 2, 2])]);
    let mut contact = scene.contact(options);
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 3]) }).expect("a plane");
    contact.set_pair_options(ON_FLOOR, pair).expect("options");
    (scene, contact)
}

fn shifted(coords: &[[f64; 3]], by: [f64; 3]) -> Vec<[f64; 3]> {
    coords.iter().map(|x| std::array::from_fn(|i| x[i] + by[i])).collect()
}

/// The unit vectors along a direction and across it in a horizontal plane.
fn axes(direction: [f64; 3]) -> [[f64; 3]; 2] {
    let size = f64::hypot(direction[0], direction[1]);
    let [x, y] = [direction[0] / size, direction[1] / size];
    [[x, y, 0.0], [-y, x, 0.0]]
}

fn dot(x: [f64; 3], y: [f64; 3]) -> f64 {
    (0..3).map(|i| x[i] * y[i]).sum()
}

/// Traction by the pressure on what slides this way: −μ² v/√((μ₁v₁)² + (μ₂v₂)²).
fn closed_form(direction: [f64; 3], [along, across]: [f64; 2], slip: [f64; 3]) -> [f64; 3] {
    let [d, e] = axes(direction);
    let (v, w) = (dot(d, slip), dot(e, slip));
    let size = f64::hypot(along * v, across * w);
    std::array::from_fn(|i| -(along * along * v * d[i] + across * across * w * e[i]) / size)
}

/// The points on horizontal faces: walls that are sunk in have another plane.
fn level(points: Vec<PointOfContact<3>>) -> Vec<PointOfContact<3>> {
    let found: Vec<_> = points.into_iter().filter(|point| point.normal[2].abs() > 0.999).collect();
    assert!(!found.is_empty());
    found
}

fn slid_to_rest(contact: &mut Contact<3>, coords: &[[f64; 3]], way: [f64; 3], steps: usize) -> Vec<[f64; 3]> {
    let mut at = coords.to_vec();
    contact.begin_step(&at).expect("a step");
    for step in 0..steps {
        at = shifted(&at, way);
        if step + 1 < steps {
            contact.commit_step(&at).expect("a step");
        }
    }
    at
}
