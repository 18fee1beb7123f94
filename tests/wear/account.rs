//! Wear by the account of the work of friction, where facets come into contact and leave it within a step.

use crate::scene::{Scene, table::exactly};
use crate::{DELTA, STIFFNESS, WEAR, laws, on_a_plane};
use fmc_contact::contact::{Friction, PairOptions};
use fmc_contact::overlap::Partner;
use fmc_contact::{Contact, EnergyLaw, Obstacle, Options, Pose, Shape};
use fmc_shapes::{cuboid_hex8, rectangle_quad4};

const COEFFICIENT: f64 = 0.2;

/// A disc that rolls with a slip on a plate that is held: where it is after so many steps.
fn rolling(step: i32, [way, slip]: [f64; 2]) -> Pose<2> {
    let (radius, depth) = (5.0, 0.004);
    let (sin, cos) = (-(way - slip) / radius * f64::from(step)).sin_cos();
    let position = [-0.5 + way * f64::from(step), radius - depth];
    Pose { position, rotation: [[cos, -sin], [sin, cos]], ..Pose::at(position) }
}

/// Wear and work of friction of all steps but the first, and Σ force · slip.
fn rolled(options: Options, by: [f64; 2], steps: i32) -> [f64; 3] {
    let plate = Scene::of(&[&rectangle_quad4([-2.0, -1.0], [2.0, 0.0], [40, 1])]);
    let mut contact = plate.contact(options);
    contact.add_obstacle(Obstacle { shape: Shape::Ball { radius: 5.0 }, pose: rolling(0, by) }).expect("a disc");
    let pair = [Partner::Body(0), Partner::Obstacle(0)];
    contact.set_pair_options(pair, Some(PairOptions::with_wear([1e-9, 0.0]))).expect("a pair that wears");
    contact.begin_step(&plate.coords).expect("a step");
    let (mut first, mut work, mut expected) = (0.0, 0.0, 0.0);
    for step in 1..=steps {
        contact.set_pose(0, rolling(step, by)).expect("the disc");
        let found = contact.evaluate(&plate.coords).expect("forces");
        contact.commit_step(&plate.coords).expect("a step");
        if step == 1 {
            first = contact.wear().expect("a step").volumes[0];
        } else {
            work += found.friction.dissipated;
            expected += found.obstacles[0].force[1].abs() * by[1].abs();
        }
    }
    [(contact.wear().expect("a step").volumes[0] - first) / 1e-9, work, expected]
}

#[test]
fn a_disc_that_rolls_with_a_slip() {
    // Steps of a quarter of the contact leave what the trapezoidal rule does of pressures that come and go, which falls with the step; and
    // the slip of the contact is that at the disc, by its depth and its stretched way.
    for (by, steps, most) in [
        ([0.1, -0.1], 8, 0.025),
        ([0.05, -0.05], 16, 0.006),
        ([0.025, -0.025], 32, 0.004),
        ([0.1, 0.1], 8, 0.003),
        ([0.1, -0.4], 8, 0.025),
        ([0.0, 0.1], 8, 0.003),
    ] {
        let law = EnergyLaw::depth(1e6);
        let [volume, work, expected] =
            rolled(Options { friction: Friction::coulomb(COEFFICIENT), ..exactly(law) }, by, steps);
        assert!((volume / expected - 1.0).abs() < most, "{by:?}: {volume} {expected}");
        // The same account: but for the pull of elastic slip that turned along, of a thousandth of the slip.
        assert!((volume * COEFFICIENT / work - 1.0).abs() < 2e-4, "{by:?}: {volume} {work}");
    }
}

/// A pin at 5 from the axis about which a plane turns, which turns by `angle` in each of three steps: wear and work of each by those of the arc,
/// and the elastic slip by the arc.
fn on_a_disc(options: Options, angle: f64) -> Vec<[f64; 3]> {
    let pin = Scene::of(&[&cuboid_hex8([4.5, -0.5, -DELTA], [5.5, 0.5, 1.0], [4, 4, 2])]);
    let mut contact = on_a_plane(&pin, options);
    contact.set_wear_cycles(1e-6).expect("cycles");
    contact.begin_step(&pin.coords).expect("a step");
    // The mean of the radius over the pin, but for terms of the fourth order of its width.
    let arc = angle.abs() * 5.0 * (1.0 + 1.0 / 600.0);
    let (mut before, mut all) = (0.0, Vec::new());
    for step in 1..=3 {
        let (sin, cos) = (angle * f64::from(step)).sin_cos();
        let rotation = [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]];
        contact.set_pose(0, Pose { rotation, ..Pose::at([0.0; 3]) }).expect("the plane");
        let found = contact.evaluate(&pin.coords).expect("forces");
        let expected = found.obstacles[0].force[2].abs() * arc;
        contact.commit_step(&pin.coords).expect("a step");
        let volume = contact.wear().expect("a step").volumes[0];
        let wear = (volume - before) / (1e-6 * WEAR[0] * expected);
        all.push([wear, found.friction.dissipated / (COEFFICIENT * expected), COEFFICIENT * DELTA / arc]);
        before = volume;
    }
    all
}

/// What turns slips by its arc, in steps of any angle below half a turn.
#[test]
fn a_pin_on_a_disc() {
    for angle in [0.02, 0.3, 1.0, 2.5, -2.9] {
        for options in laws(0.0).into_iter().chain(laws(COEFFICIENT)) {
            for [wear, work, elastic] in on_a_disc(options, angle) {
                // Facets of 1/4 slip by the mean of their points, the pressure falls by 3e-6 in a step, and walls of a width of DELTA bear too. Elastic slip turns along with the mean of
                // both sides.
                let most = 1e-3 + 2.0 * elastic;
                let has_friction = options.friction.coefficient > 0.0;
                assert!((wear - 1.0).abs() < most, "{angle}: {wear} {options:?}");
                assert!(!has_friction || (work - 1.0).abs() < most, "{angle}: {work} {options:?}");
            }
        }
    }
}

/// With cohesion or a limit of the traction wear is by the pressure, and not by the work alone.
#[test]
fn the_pressure_wears_whatever_else_holds() {
    let pressure = STIFFNESS * DELTA;
    for friction in [
        Friction { cohesion: 0.5 * pressure, ..Friction::coulomb(0.3) },
        Friction { shear_limit: 0.1 * pressure, ..Friction::coulomb(0.3) },
        Friction { memoryless_slip: Some(1e-3), ..Friction::coulomb(0.3) },
    ] {
        let block = Scene::of(&[&rectangle_quad4([0.0, -DELTA], [1.0, 1.0], [3, 2])]);
        let mut contact: Contact<2> = on_a_plane(&block, Options { friction, ..exactly(EnergyLaw::depth(STIFFNESS)) });
        contact.set_wear_cycles(1e-3).expect("cycles");
        contact.begin_step(&block.coords).expect("a step");
        for step in 1..=2 {
            contact.set_pose(0, Pose::at([0.1 * f64::from(step), 0.0])).expect("the plane");
            contact.commit_step(&block.coords).expect("a step");
        }
        let found = contact.wear().expect("a step").volumes[0] / (1e-3 * WEAR[0] * pressure * 0.2);
        // Walls of the depth DELTA, and an elastic slip of DELTA at most.
        assert!((found - 1.0).abs() < 5e-3, "{found} {friction:?}");
    }
}
