//! A block that is pushed along another: held by the stick up to its limit, then by μ times the pressure.

use crate::scene::{Scene, cross, norm, size_sum};
use crate::{STIFFNESS, begun, in_plane, in_space, laws, moved, slid};
use fmc_contact::contact::{Friction, PairOptions};
use fmc_contact::overlap::Partner;
use fmc_contact::{ContactForces, Error, Obstacle, Options, Pose, Shape};

const MU: f64 = 0.3;
const DELTA: f64 = 1e-3;

fn balances<const D: usize>(found: &ContactForces<D>, coords: &[[f64; D]]) {
    let sizes = size_sum(&found.forces);
    let force: [f64; D] = std::array::from_fn(|i| found.forces.iter().map(|f| f[i]).sum());
    let moment: [f64; 3] = std::array::from_fn(|i| coords.iter().zip(&found.forces).map(|(x, f)| cross(x, f)[i]).sum());
    assert!(norm(&[force]) < 1e-12 * sizes && norm(&[moment]) < 1e-12 * sizes, "{force:?} {moment:?} of {sizes}");
}

/// The normal traction of all points: Σ p A.
fn pressed<const D: usize>(scene: &Scene<D>, options: Options, coords: &[[f64; D]]) -> f64 {
    let points = scene.contact(Options { friction: Friction::default(), ..options }).contact_points(coords);
    points.expect("points").iter().map(|point| point.pressure * point.area).sum()
}

fn pushed<const D: usize>(scene: &Scene<D>, options: Options) {
    let contact = begun(scene, options, &scene.coords);
    let force_at = |by: f64| {
        let coords = slid(scene, by);
        let found = contact.evaluate(&coords).expect("valid coordinates");
        balances(&found, &coords);
        assert!((found.bodies[0].friction[0] + found.bodies[1].friction[0]).abs() < 1e-12);
        (found, pressed(scene, options, &coords))
    };
    let area: f64 = if D == 2 { 1.0 } else { 0.8 };
    let limit = MU * DELTA;
    // Stuck, both ways: a spring of stiffness k, whose area is that of the face, but for the rim.
    for by in [0.1 * limit, -0.5 * limit] {
        let (found, _) = force_at(by);
        let held = found.bodies[1].friction[0] / (-STIFFNESS * area * by);
        assert!((held - 1.0).abs() < 0.02, "{held}");
        // Walls that are sunk in bear little.
        let friction = found.friction;
        assert!(friction.dissipated < 1e-3 * friction.stored && friction.slip_area < 0.02, "{friction:?}");
        let stored = found.friction.stored / (0.5 * STIFFNESS * area * by * by);
        assert!((stored - 1.0).abs() < 0.02, "{stored}");
    }
    // All points slide: the force is the limit but for the walls that are sunk in, where the slip runs along the normal.
    for by in [5.0 * limit, -80.0 * limit] {
        let (found, pressed) = force_at(by);
        let force = found.bodies[1].friction[0] / (-by.signum() * MU * pressed);
        assert!((force - 1.0).abs() < 0.02, "{force}");
        let lost = found.friction.dissipated / (MU * pressed * (by.abs() - limit));
        assert!((lost - 1.0).abs() < 0.02, "{lost}");
        assert!(found.friction.stick_area < 0.02 * area && found.friction.largest_slip < by.abs());
    }
}

#[test]
fn a_block_sticks_and_slides() {
    in_plane(DELTA).iter().for_each(|scene| laws(MU).into_iter().for_each(|options| pushed(scene, options)));
    in_space(DELTA).iter().for_each(|scene| laws(MU).into_iter().for_each(|options| pushed(scene, options)));
}

/// Of the block with the law `depth` the force is μ N to 1e-3: the walls are pressed by k δ²/2.
#[test]
fn the_limit_is_that_of_the_normal_force() {
    for scene in in_plane(DELTA) {
        let contact = begun(&scene, laws(MU)[0], &scene.coords);
        let found = contact.evaluate(&slid(&scene, 0.02)).expect("valid coordinates");
        let body = &found.bodies[1];
        let ratio = -body.friction[0] / (body.force[1] - body.friction[1]);
        assert!((ratio / MU - 1.0).abs() < 2e-3, "{ratio}");
    }
}

#[test]
fn without_friction_every_bit_stays() {
    let scene = &in_space(DELTA)[0];
    for options in laws(0.0) {
        let coords = slid(scene, 0.01);
        let without = scene.contact(options).evaluate(&coords).expect("valid coordinates");
        assert_eq!(begun(scene, options, &scene.coords).evaluate(&coords).expect("valid coordinates"), without);
        // A pair whose own coefficient is zero.
        let mut contact = begun(scene, Options { friction: Friction::coulomb(MU), ..options }, &scene.coords);
        let pair = [Partner::Body(0), Partner::Body(1)];
        contact.set_pair_options(pair, Some(PairOptions::with_friction(0.0))).expect("a pair");
        assert_eq!(contact.evaluate(&coords).expect("valid coordinates"), without);
    }
}

#[test]
fn friction_needs_a_step() {
    let scene = &in_plane(DELTA)[0];
    let mut contact = scene.contact(laws(MU)[0]);
    assert_eq!(contact.evaluate(&scene.coords).unwrap_err(), Error::NoStep);
    assert_eq!(contact.commit_step(&scene.coords).unwrap_err(), Error::NoStep);
    assert_eq!(contact.slip().unwrap_err(), Error::NoStep);
    contact.begin_step(&scene.coords).expect("valid coordinates");
    assert!(contact.evaluate(&scene.coords).is_ok() && contact.slip().is_ok());
    for (name, friction) in [
        ("friction_coefficient", Friction::coulomb(-0.1)),
        ("friction_stiffness", Friction { stiffness: Some(0.0), ..Friction::coulomb(0.1) }),
        ("cohesion", Friction { cohesion: f64::NAN, ..Friction::default() }),
        ("shear_limit", Friction { shear_limit: 0.0, ..Friction::default() }),
    ] {
        let refused = scene.contact(laws(MU)[0]).set_options(Options { friction, ..laws(MU)[0] });
        assert!(matches!(refused, Err(Error::NotPositive { name: found, .. }) if found == name), "{refused:?}");
    }
}

/// A rigid plane and a rigid cuboid, moved in place of the block: what counts is the motion of one against the other.
#[test]
fn obstacles_that_move() {
    let lower = fmc_shapes::cuboid_tet4([-0.5, -0.4, 0.0], [0.5, 0.4, 0.7], [2, 2, 2]);
    let scene = Scene::of(&[&lower]);
    let cuboid = Shape::Cuboid { half_extents: [1.1, 0.9, 0.3] };
    for (shape, below) in [(Shape::HalfSpace, DELTA), (cuboid, DELTA - 0.3)] {
        for options in laws(MU) {
            let limit = MU * DELTA;
            for by in [0.3 * limit, 6.0 * limit] {
                let at = |x: f64| Pose::at([x, 0.0, below]);
                let mut contact = scene.contact(options);
                contact.add_obstacle(Obstacle { shape: shape.clone(), pose: at(0.0) }).expect("an obstacle");
                contact.begin_step(&scene.coords).expect("valid coordinates");
                contact.set_pose(0, at(by)).expect("a pose");
                let carried = contact.evaluate(&scene.coords).expect("valid coordinates");
                contact.set_pose(0, at(0.0)).expect("a pose");
                let back = moved(&scene, 0, |x| [x[0] - by, x[1], x[2]]);
                let pushed = contact.evaluate(&back).expect("valid coordinates");
                let (force, other) = (carried.bodies[0].friction[0], pushed.bodies[0].friction[0]);
                assert!(force > 0.0 && (force - other).abs() < 1e-9 * force, "{force} {other}");
                let expected = STIFFNESS * 0.8 * by.min(limit);
                assert!((force / expected - 1.0).abs() < 0.02, "{force} {expected}");
                let reaction = &carried.obstacles[0];
                assert!((reaction.friction[0] + force).abs() < 1e-12 * force);
                let turning: f64 = (0..3).map(|i| (reaction.moment[i] + carried.bodies[0].moment[i]).abs()).sum();
                assert!(turning < 1e-12, "{turning}");
            }
        }
    }
}
