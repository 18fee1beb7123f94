//! Contact with an obstacle that begins at a distance from its surface.

use crate::depth;
use crate::obstacles::{Deviations, against, deviations_of, disturbed};
use crate::scene::Scene;
use crate::scene::table::exactly;
use fmc_contact::contact::{Friction, PairOptions, TangentPart};
use fmc_contact::overlap::Partner::{Body, Obstacle as Rigid};
use fmc_contact::{Contact, ContactForces, EnergyLaw, Error, Estimator, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, random_rotation, rectangle_quad4, rectangle_tri3};
use std::f64::consts::PI;
use std::sync::Arc;

fn with_offset<const D: usize>(mut contact: Contact<D>, offset: f64) -> Contact<D> {
    contact.set_pair_options([Body(0), Rigid(0)], Some(PairOptions::with_gap_offset(offset))).unwrap();
    contact
}

/// A mesh against one obstacle, from which the contact is at a distance.
fn offset<const D: usize>(
    mesh: &Mesh<D>,
    shape: &Shape<D>,
    pose: Pose<D>,
    options: Options,
    by: f64,
) -> (Scene<D>, Contact<D>) {
    let scene = Scene::of(&[mesh]);
    let mut contact = scene.contact(options);
    contact.add_obstacle(Obstacle { shape: shape.clone(), pose }).unwrap();
    (scene, with_offset(contact, by))
}

fn evaluate<const D: usize>((scene, contact): &(Scene<D>, Contact<D>)) -> ContactForces<D> {
    contact.evaluate(&scene.coords).unwrap()
}

fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{what}: {found} instead of {expected}");
}

/// All laws with the estimators that they have.
fn laws() -> Vec<Options> {
    let [volume, fiber] = [EnergyLaw::volume(2.0), EnergyLaw::fiber(2.0)];
    let auto = |law| Options { estimator: Estimator::Auto(Default::default()), ..exactly(law) };
    vec![exactly(EnergyLaw::depth(2.0)), exactly(volume), exactly(fiber), auto(volume), auto(fiber)]
}

/// A half-space, a gap of 0.02 under a shell of 0.1: the pressure is k (0.1 − 0.02), and all else is that of the plane
/// 0.1 further out, by every law.
#[test]
fn a_shell_on_a_plane() {
    let mesh = rectangle_quad4([0.0, 0.02], [1.0, 1.0], [4, 3]);
    let turned = |height: f64| Pose { position: [-0.1 * height, height], ..Pose::default() };
    for options in laws() {
        let at = evaluate(&offset(&mesh, &Shape::HalfSpace, turned(0.0).scaled(3.0), options, 0.1));
        let mut plain = Scene::of(&[&mesh]).contact(options);
        plain.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: turned(0.1).scaled(3.0) }).unwrap();
        let expected = plain.evaluate(&mesh.coords).unwrap();
        if matches!(options.law, EnergyLaw::Depth { .. }) {
            close("force", at.bodies[0].force[1], 2.0 * 0.08, 1e-12);
            close("energy", at.energy, 0.08f64.powi(2), 1e-12);
        }
        close("energy", at.energy, expected.energy, 1e-13);
        close("penetration", at.penetration, 0.08, 1e-12);
        close("volume", at.volume, 0.08, 1e-12);
        for (force, expected) in at.forces.iter().flatten().zip(expected.forces.iter().flatten()) {
            assert!((force - expected).abs() < 1e-14, "{force} {expected}");
        }
        assert!((at.bodies[0].force[1] + at.obstacles[0].force[1]).abs() < 1e-15);
        // A clearance of 0.01 in place of the gap leaves nothing.
        assert_eq!(evaluate(&offset(&mesh, &Shape::HalfSpace, turned(0.0), options, -0.01)).energy, 0.0);
        assert_eq!(evaluate(&offset(&mesh, &Shape::HalfSpace, turned(0.0), options, 0.02)).energy, 0.0);
    }
}

/// Balls and capsules are larger or smaller ones, cylinders inwards too: the same bits, by the laws of their estimator,
/// and the offset is a length in space, whatever the scale, also when that changes.
#[test]
fn shapes_of_the_same_kind() {
    let mesh = cuboid_tet4([-1.0, -1.1, -1.0], [1.05, 1.0, 0.0], [3, 4, 2]);
    let ball = |radius| Shape::Ball { radius };
    let capsule = |radius| Shape::Capsule { radius, half_height: 0.3 };
    let cylinder = |radius| Shape::Cylinder { radius, half_height: 0.5 * radius };
    let scale = 0.5;
    let pose = Pose { rotation: random_rotation(3), ..Pose::at([0.1, 0.05, 0.35]) };
    let cases = [
        (ball(1.0), ball(1.25), 0.125),
        (ball(1.0), ball(0.75), -0.125),
        (capsule(0.75), capsule(1.0), 0.125),
        (cylinder(2.0), Shape::Cylinder { radius: 1.75, half_height: 0.75 }, -0.125),
    ];
    for (shape, other, by) in cases {
        let by_lines = Options { estimator: Estimator::Auto(Default::default()), ..exactly(EnergyLaw::fiber(1.0)) };
        for options in [depth(1.0), by_lines] {
            let mut expected = Scene::of(&[&mesh]).contact(options);
            expected.add_obstacle(Obstacle { shape: other.clone(), pose: pose.scaled(scale) }).unwrap();
            let expected = expected.evaluate(&mesh.coords).unwrap();
            assert!(expected.energy > 0.0);
            assert_eq!(evaluate(&offset(&mesh, &shape, pose.scaled(scale), options, by)), expected, "{shape:?}");
            let (scene, mut contact) = offset(&mesh, &shape, pose, options, by);
            contact.set_pose(0, pose.scaled(scale)).unwrap();
            assert_eq!(contact.evaluate(&scene.coords).unwrap(), expected, "{shape:?}, scaled later");
        }
    }
}

/// A ball of no size, a point: the contact begins at a ball around it; one that is offset inwards by more than its radius
/// is not there.
#[test]
fn what_is_left_of_small_shapes() {
    let mesh = rectangle_tri3([-1.0, -1.0], [1.0, 0.0], [6, 4], Diagonals::Alternating);
    for shape in [Shape::Ball { radius: 0.2 }, Shape::Capsule { radius: 0.2, half_height: 0.1 }] {
        assert_eq!(evaluate(&offset(&mesh, &shape, Pose::at([0.0, 0.1]), depth(1.0), -0.2)).energy, 0.0);
        assert_eq!(evaluate(&offset(&mesh, &shape, Pose::at([0.0, 0.1]), depth(1.0), -0.5)).energy, 0.0);
    }
    let plate = Shape::Cuboid { half_extents: [0.5, 1e-3] };
    // A sheet with a shell of 0.1 on both sides, its middle 0.05 above the face: 0.051 deep but for the round edges.
    let at = evaluate(&offset(&mesh, &plate, Pose::at([0.0, 0.05]), depth(1.0), 0.1));
    // Beside the sheet's end the depth is 0.1 − |x − end|, from end at height 0.049 on: a circular segment.
    let (r, h) = (0.1f64, 0.05f64 - 1e-3);
    let a = (r * r - h * h).sqrt();
    let round = r * a - (0.5 * a * r + 0.5 * h * h * (a / h).asinh());
    close("force", -at.bodies[0].force[1], 0.051 + 2.0 * round, 2e-6);
}

/// An edge of a box that points outwards is round: the signed distance of the box, less the offset, as a host would
/// write it down. Inwards it stays sharp: a smaller box, whose integrals are exact.
#[test]
fn boxes_and_polytopes() {
    let mesh = rectangle_tri3([0.1, -1.0], [1.2, 0.3], [5, 4], Diagonals::Alternating);
    let half = [0.5, 0.25];
    let cuboid = Shape::Cuboid { half_extents: half };
    let corners = vec![[-0.5, -0.25], [0.5, -0.25], [0.5, 0.25], [-0.5, 0.25]];
    let polytope = Shape::Polytope { points: corners.clone(), facets: vec![[0, 1], [1, 2], [2, 3], [3, 0]] };
    let hull = Shape::ConvexHull { points: corners };
    let pose = Pose::at([0.1, 0.4]).turned(0.3);
    let rounded = |by: f64| {
        let distance = move |x: &[f64; 2]| {
            let out = [x[0].abs() - half[0], x[1].abs() - half[1]];
            let outside = [out[0].max(0.0), out[1].max(0.0)];
            let far = outside[0].hypot(outside[1]);
            let sign = [x[0].signum(), x[1].signum()];
            if far > 0.0 {
                (far - by, [outside[0] / far * sign[0], outside[1] / far * sign[1]])
            } else if out[0] > out[1] {
                (out[0] - by, [sign[0], 0.0])
            } else {
                (out[1] - by, [0.0, sign[1]])
            }
        };
        Shape::SignedDistance(Arc::new(distance))
    };
    for shape in [&cuboid, &polytope, &hull] {
        for (by, other) in [(0.1, rounded(0.1)), (-0.1, Shape::Cuboid { half_extents: [0.4, 0.15] })] {
            let at = evaluate(&offset(&mesh, shape, pose, depth(1.0), by));
            let (scene, plain) = against(&mesh, &other, pose, 1.0);
            let expected = plain.evaluate(&scene.coords).unwrap();
            assert!(expected.energy > 0.0);
            close("energy", at.energy, expected.energy, 1e-5);
            close("force", at.bodies[0].force[1], expected.bodies[0].force[1], 1e-6);
            let turn = [at.obstacles[0].moment[2], expected.obstacles[0].moment[2]];
            close("moment", turn[0], turn[1], 1e-5);
        }
    }
}

/// A block whose face at height 0 looks at a ball at a distance, which a shell bridges: the force on a cap of the ball with
/// the shell. By the shape, by its facets as a polytope not, by a function of the host and by a compound.
#[test]
fn a_shell_on_a_ball() {
    let (radius, by, delta) = (0.4f64, 0.1, 0.05);
    let r = radius + by;
    let h = r - delta;
    let force = PI * (r * (r * r - h * h) - 2.0 / 3.0 * (r.powi(3) - h.powi(3)));
    let mesh = cuboid_tet4([-1.0, -1.1, -1.0], [1.05, 1.0, 0.0], [20, 20, 2]);
    let distance = move |x: &[f64; 3]| {
        let r = x.iter().map(|x| x * x).sum::<f64>().sqrt();
        (r - radius, x.map(|x| x / r))
    };
    let ball = Shape::Ball { radius };
    let compound = Shape::Compound { parts: vec![Obstacle { shape: ball.clone(), pose: Pose::default() }] };
    for shape in [ball, Shape::SignedDistance(Arc::new(distance)), compound] {
        let at = evaluate(&offset(&mesh, &shape, Pose::at([0.0, 0.0, h]), depth(1.0), by));
        close("force", -at.bodies[0].force[2], force, 1e-6);
    }
}

/// Force against differences of the energy, tangent against differences of the force, ΣF, ΣM.
#[test]
fn derivatives() {
    let check = |found: Deviations, [force, tangent]: [f64; 2]| {
        println!("force {:.1e}, tangent {:.1e}, balance {:.1e}", found.force, found.tangent, found.balance);
        assert!(found.force < force && found.tangent < tangent && found.balance < 1e-12);
    };
    // In closed form.
    for mesh in [cuboid_hex8([0.0; 3], [1.0; 3], [3, 2, 2]), cuboid_tet4([0.0; 3], [1.0; 3], [2, 2, 2])] {
        let mesh = disturbed(mesh, 1);
        let pose = Pose { rotation: random_rotation(4), ..Pose::at([0.5, 0.4, 0.4]) };
        for by in [0.1, -0.05] {
            let (scene, contact) = offset(&mesh, &Shape::HalfSpace, pose, depth(30.0), by);
            check(deviations_of(&scene, contact, pose, [1e-2, 1e-3]), [1e-7, 1e-6]);
        }
    }
    // By quadrature, as exact as it is without an offset.
    let mesh = disturbed(rectangle_tri3([0.0; 2], [1.0; 2], [4, 3], Diagonals::Alternating), 1);
    let pose = Pose { position: [0.5, 1.2], rotation: random_rotation(3), scale: 1.1 };
    let hull = Shape::ConvexHull { points: vec![[-0.3, -0.2], [0.3, -0.25], [0.2, 0.3]] };
    for (shape, by) in [
        (Shape::Ball { radius: 0.3 }, 0.1),
        (Shape::Cuboid { half_extents: [0.3, 0.25] }, 0.1),
        (Shape::Cuboid { half_extents: [0.4, 0.35] }, -0.05),
        (hull, 0.1),
    ] {
        let (scene, contact) = offset(&mesh, &shape, pose, depth(30.0), by);
        check(deviations_of(&scene, contact, pose, [1e-3, 1e-4]), [2e-5, 1e-4]);
    }
}

/// Friction: what is carried, and the force, are those of the plane further out.
#[test]
fn friction_on_a_shell() {
    let mesh = rectangle_quad4([0.0, 0.0], [1.0, 1.0], [4, 3]);
    let options = Options { friction: Friction::coulomb(0.3), ..depth(10.0) };
    let by_offset = offset(&mesh, &Shape::HalfSpace, Pose::at([0.0, -0.05]), options, 0.0625);
    let (scene, plain) = offset(&mesh, &Shape::HalfSpace, Pose::at([0.0, 0.0125]), options, 0.0);
    let moved: Vec<[f64; 2]> = scene.coords.iter().map(|x| [x[0] + 1e-3, x[1]]).collect();
    let [found, expected] = [by_offset.1, plain].map(|mut contact| {
        contact.begin_step(&scene.coords).unwrap();
        contact.commit_step(&moved).unwrap();
        let tangent = contact.tangent(&moved, TangentPart::Full).unwrap();
        let force = contact.evaluate(&moved).unwrap().bodies[0].force;
        // A facet that carries nothing has no row, and one that carries rounding may have one.
        let mut slip = vec![[0.0; 2]; scene.surface().facet_count()];
        contact.slip().unwrap().iter().for_each(|one| slip[one.facet] = one.slip);
        (slip.concat(), force, tangent)
    });
    assert!(found.1[0] < -1e-3 && found.0.iter().any(|x| x.abs() > 1e-4), "{:?}", found.1);
    let close = |a: &f64, b: &f64| (a - b).abs() < 1e-13;
    assert!(found.0.iter().zip(&expected.0).all(|(a, b)| close(a, b)));
    assert!(found.1.iter().zip(&expected.1).all(|(a, b)| close(a, b)));
    let [found, expected] = [found.2, expected.2].map(|tangent| tangent.triplets().collect::<Vec<_>>());
    assert!(found.iter().zip(&expected).all(|(a, b)| (a.0, a.1) == (b.0, b.1) && (a.2 - b.2).abs() < 1e-11));
}

/// Weighted gaps are counted from the surface further out.
#[test]
fn gaps_of_a_shell() {
    let mesh = rectangle_quad4([0.0, 0.3], [1.0, 1.0], [4, 3]);
    for shape in [Shape::HalfSpace, Shape::Cuboid { half_extents: [3.0, 1.0] }] {
        let top = if matches!(shape, Shape::HalfSpace) { 0.0 } else { -1.0 };
        let (scene, contact) = offset(&mesh, &shape, Pose::at([0.0, top]), depth(1.0), 0.1);
        let gaps = contact.gap_constraints(&scene.coords, 0.25).unwrap();
        assert_eq!(gaps.nodes.len(), 5);
        assert!(gaps.gaps.iter().zip(&gaps.areas).all(|(gap, area)| (gap / area - 0.2).abs() < 1e-12));
        assert!(contact.gap_constraints(&scene.coords, 0.15).unwrap().nodes.is_empty());
    }
}

/// Only of one body: another meets the obstacle where it is.
#[test]
fn every_pair_has_its_own() {
    let lower = rectangle_quad4([0.0, 0.05], [1.0, 1.0], [2, 2]);
    let other = rectangle_quad4([3.0, -0.02], [4.0, 1.0], [2, 2]);
    let scene = Scene::of(&[&lower, &other]);
    let mut contact = scene.contact(depth(1.0));
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::default() }).unwrap();
    let contact = with_offset(contact, 0.1);
    let at = contact.evaluate(&scene.coords).unwrap();
    close("with a shell", at.bodies[0].force[1], 0.05, 1e-12);
    close("without", at.bodies[1].force[1], 0.02, 1e-12);
    assert_eq!(contact.pair_options([Rigid(0), Body(0)]).unwrap().unwrap().gap_offset, 0.1);
}

#[test]
fn what_cannot_be_is_refused() {
    let mesh = rectangle_quad4([0.0, 0.0], [1.0, 1.0], [2, 2]);
    let scene = Scene::of(&[&mesh, &mesh.clone().translated([0.9, 0.1])]);
    let mut contact = scene.contact(depth(1.0));
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::default() }).unwrap();
    for pair in [[Body(0), Body(1)], [Body(1), Body(1)]] {
        let refused = contact.set_pair_options(pair, Some(PairOptions::with_gap_offset(0.1)));
        assert!(refused.unwrap_err().to_string().contains("a positive gap offset between bodies"));
        let by_fiber = PairOptions { law: Some(EnergyLaw::fiber(1.0)), ..PairOptions::with_gap_offset(-0.1) };
        let refused = contact.set_pair_options(pair, Some(by_fiber));
        assert!(refused.unwrap_err().to_string().contains("by another law than depth"));
        assert_eq!(contact.pair_options(pair), Ok(None));
        contact.set_pair_options(pair, Some(PairOptions::with_gap_offset(-0.1))).unwrap();
        let refused = contact.set_options(exactly(EnergyLaw::fiber(1.0)));
        assert!(refused.unwrap_err().to_string().contains("by another law than depth"));
        contact.set_pair_options(pair, None).unwrap();
    }
    for by in [f64::NAN, f64::INFINITY] {
        let refused = contact.set_pair_options([Body(0), Rigid(0)], Some(PairOptions::with_gap_offset(by)));
        assert!(matches!(refused, Err(Error::OfPair { cause, .. }) if cause.to_string().contains("'gap_offset'")));
    }
}
