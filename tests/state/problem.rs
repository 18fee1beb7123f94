//! The problem of these tests: every part of a contact has something to say in it.

use crate::scene::Scene;
use crate::scene::table::exactly;
use fmc_contact::contact::Friction;
use fmc_contact::{Contact, EnergyLaw, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Mesh, rectangle_quad4, rectangle_tri3};

/// How deep bodies lie in one another.
pub(crate) const DELTA: f64 = 1e-3;

/// k of all laws whose pressure is k times a length.
pub(crate) const STIFFNESS: f64 = 1e3;

/// A block, and a body in two pieces on it that overlap; away from the axis of rotation.
pub(crate) fn scene() -> Scene<2> {
    let below = rectangle_tri3([0.5, -0.6], [2.7, 0.0], [6, 2], fmc_shapes::Diagonals::Alternating);
    let mut above: Mesh<2> = rectangle_quad4([1.0, -DELTA], [1.6, 0.7], [3, 2]);
    above.append(&rectangle_quad4([1.6 - DELTA, -DELTA], [2.1, 0.6], [2, 2]));
    Scene::of(&[&below, &above])
}

/// The upper body moved along by this much and up by that, and bent a little, as no one number of a contact is then like another.
pub(crate) fn moved(scene: &Scene<2>, along: f64, up: f64) -> Vec<[f64; 2]> {
    let mut coords = scene.coords.clone();
    for node in scene.nodes_of(1) {
        let [x, y] = coords[node];
        coords[node] = [x + along * (1.0 + 0.1 * y), y + up + 0.1 * up.abs() * (3.0 * x).sin()];
    }
    coords
}

/// A plane below and a wall at the right, both touched.
pub(crate) fn obstacles() -> [Obstacle<2>; 2] {
    let plane = Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, -0.6 + DELTA]) };
    [plane, Obstacle { shape: Shape::Cuboid { half_extents: [0.2, 0.3] }, pose: wall() }]
}

/// Where the wall stands.
pub(crate) fn wall() -> Pose<2> {
    Pose::at([2.3 - DELTA, 0.35])
}

/// One problem: the options that the contact has in the end, and the settings that make sense with them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Problem {
    pub(crate) options: Options,
    /// Whether friction is frozen in the end.
    pub(crate) freezes: bool,
}

impl Problem {
    pub(crate) fn has_friction(&self) -> bool {
        self.options.friction.is_active()
    }

    /// A contact with these options and the obstacles.
    pub(crate) fn contact(&self, scene: &Scene<2>) -> Contact<2> {
        let mut contact = scene.contact(self.options);
        obstacles().into_iter().for_each(|obstacle| {
            contact.add_obstacle(obstacle).expect("an obstacle");
        });
        contact
    }
}

fn laws() -> [EnergyLaw; 3] {
    [
        EnergyLaw::depth(STIFFNESS),
        EnergyLaw::Volume { stiffness: STIFFNESS, exponent: 2.0 },
        EnergyLaw::fiber(STIFFNESS),
    ]
}

/// Every law: with friction and self-contact, the same frozen, and without either.
pub(crate) fn problems() -> Vec<Problem> {
    let friction = Friction { stiffness: Some(STIFFNESS), ..Friction::coulomb(0.3) };
    let of_law = |law| {
        let smooth = exactly(law);
        let rough = Options { friction, self_contact: true, ..smooth };
        [(smooth, false), (rough, false), (rough, true)].map(|(options, freezes)| Problem { options, freezes })
    };
    laws().into_iter().flat_map(of_law).collect()
}
