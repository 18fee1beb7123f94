//! Bodies that let one another in by a clearance before they press: a negative gap offset.

use crate::depth;
use crate::derivatives::{
    check_all, force_is_the_slope_of_the_energy, in_plane, in_space, tangent_is_the_slope_of_the_force,
};
use crate::scene::{Scene, distance, size_sum};
use fmc_contact::contact::PairOptions;
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, Options};
use fmc_shapes::{Diagonals, Mesh, Splitmix, cuboid_hex8, rectangle_quad4, rectangle_tri3};

fn with_clearance<const D: usize>(mut contact: Contact<D>, pair: [usize; 2], clearance: f64) -> Contact<D> {
    contact.set_pair_options(pair.map(Body), Some(PairOptions::with_gap_offset(-clearance))).unwrap();
    contact
}

fn close(what: &str, found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 1e-9, "{what}: {found} instead of {expected}");
}

/// A unit block δ deep in a larger one, both of squares, whose depth is the distance from their surface. What is deeper
/// than c below the large one is e = δ − c high and 1 wide, below the small one, whose side walls count too, 1 − 2c wide:
/// J = ½ (e²/2 + (1 − 2c) e²/2 − e³/3).
#[test]
fn a_block_in_a_larger_one() {
    let large = rectangle_quad4([-1.0, -1.0], [2.0, 0.0], [6, 2]);
    let small = rectangle_quad4([0.0, 0.0], [1.0, 1.0], [2, 2]);
    let reference = Scene::of(&[&large, &small]);
    for (delta, c) in [(0.1, 0.02), (0.1, 0.0999), (0.2, 0.05), (0.05, 1e-6)] {
        let (e, width) = (delta - c, 1.0 - 2.0 * c);
        let scene = Scene::of(&[&large, &small.clone().translated([0.0, -delta])]);
        let contact = with_clearance(reference.contact(depth(2.0)), [0, 1], c);
        let at = contact.evaluate(&scene.coords).unwrap();
        // The depths of both bodies are found to 1e-15, of which e is a difference.
        let loose = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-9 + 1e-14 / e;
        assert!(loose(at.energy, 2.0 * 0.5 * (0.5 * e * e * (1.0 + width) - e * e * e / 3.0)), "{}", at.energy);
        let force = 2.0 * 0.5 * (e * (1.0 + width) - e * e);
        assert!(loose(at.bodies[1].force[1], force) && loose(-at.bodies[0].force[1], force));
        assert!(loose(at.penetration, e), "{}", at.penetration);
        assert!(loose(at.volume, 0.5 * e * (1.0 + width)), "{}", at.volume);
        let nodal = contact.nodal_contact(&scene.coords).unwrap();
        let pressure: f64 = nodal.pressure.iter().zip(&nodal.area).map(|(p, a)| p * a).sum();
        assert!(pressure > force);
        // Weighted gaps are counted from there too.
        let [gaps, plain] =
            [contact, reference.contact(depth(2.0))].map(|c| c.gap_constraints(&scene.coords, 0.1).unwrap());
        for ((gap, plain), area) in gaps.gaps.iter().zip(&plain.gaps).zip(&gaps.areas) {
            assert!((gap - plain - c * area).abs() < 1e-14);
        }
    }
    for c in [0.1, 0.2, 5.0] {
        let scene = Scene::of(&[&large, &small.clone().translated([0.0, -0.1])]);
        let at = with_clearance(reference.contact(depth(2.0)), [1, 0], c).evaluate(&scene.coords).unwrap();
        assert!(at.energy < 1e-20 && at.forces.iter().flatten().all(|f| f.abs() < 1e-12));
    }
}

/// The same in space, on a face far from the walls of the lower body; the upper one has walls on four sides.
#[test]
fn a_cube_in_a_larger_one() {
    let large = cuboid_hex8([-1.0, -1.0, -1.0], [2.0, 2.0, 0.0], [3, 3, 2]);
    let small = cuboid_hex8([0.0; 3], [1.0; 3], [2; 3]);
    let reference = Scene::of(&[&large, &small]);
    let (delta, c) = (0.2, 0.05);
    let scene = Scene::of(&[&large, &small.clone().translated([0.0, 0.0, -delta])]);
    let at = with_clearance(reference.contact(depth(1.0)), [0, 1], c).evaluate(&scene.coords).unwrap();
    let (e, width) = (delta - c, 1.0 - 2.0 * c);
    // ∫_0^e y ((w − 2y)² + ...): the depth is at least y on a square of side w − 2y, and no more than the height is.
    let below = |y: f64| -> f64 { (e - y) * (width - 2.0 * y).powi(2) };
    let steps = 1000;
    let h = e / f64::from(steps);
    let simpson: f64 = (0..steps)
        .map(|n| {
            let y = f64::from(n) * h;
            h / 6.0 * (below(y) + 4.0 * below(y + 0.5 * h) + below(y + h))
        })
        .sum();
    close("energy", at.energy, 0.5 * (0.5 * e * e + simpson));
}

/// Force, tangent, balance, as without: on meshes that were disturbed.
#[test]
fn derivatives() {
    for clearance in [0.03, 0.08] {
        in_plane(|contact, coords| check_all(&with_clearance(contact, [0, 1], clearance), &coords));
        in_space(|contact, coords| check_all(&with_clearance(contact, [0, 1], clearance), &coords));
    }
}

/// On rings.
#[test]
fn derivatives_with_axisymmetry() {
    let lower = rectangle_tri3([1.0, -1.0], [2.5, 0.0], [5, 3], Diagonals::Alternating);
    let upper = rectangle_quad4([1.3, 0.0], [2.3, 0.8], [3, 2]);
    let scene = Scene::of(&[&lower, &upper]);
    let mut random = Splitmix::new(3);
    let mut coords = scene.coords.clone();
    scene.nodes_of(1).for_each(|node| coords[node][1] -= 0.3);
    coords.iter_mut().flatten().for_each(|x| *x += random.between(-0.02, 0.02));
    let options = Options { axisymmetric: true, ..depth(30.0) };
    let contact = with_clearance(scene.contact(options), [0, 1], 0.07);
    force_is_the_slope_of_the_energy(&contact, &coords, 1e-7);
    tangent_is_the_slope_of_the_force(&contact, &coords, 1e-6);
}

/// Two blocks under one number that overlap are two bodies that do.
#[test]
fn of_a_body_with_itself() {
    let (lower, upper): (Mesh<2>, Mesh<2>) = (
        rectangle_tri3([0.0, -1.0], [1.0, 0.0], [5, 5], Diagonals::Same).rotated(0.1),
        rectangle_tri3([0.1, -0.1], [0.8, 0.6], [3, 4], Diagonals::Alternating),
    );
    let away = upper.clone().mapped(|x| x.map(|x| x + 5.0));
    let coords = Scene::of(&[&lower, &upper]).coords;
    let two = with_clearance(Scene::of(&[&lower, &away]).contact(depth(7.0)), [0, 1], 0.03);
    let one = with_clearance(Scene::new().with(&lower, 0).with(&away, 0).contact(depth(7.0)), [0, 0], 0.03);
    let [two, one] = [two, one].map(|contact| contact.evaluate(&coords).unwrap());
    assert!(two.energy > 0.0 && (one.energy - two.energy).abs() < 1e-12 * two.energy);
    assert!(distance(&one.forces, &two.forces) < 1e-12 * size_sum(&two.forces));
}

/// No clearance: the bits of a pair without options.
#[test]
fn none_is_none() {
    in_space(|contact, coords| {
        let expected = contact.evaluate(&coords).unwrap();
        assert_eq!(with_clearance(contact, [0, 1], 0.0).evaluate(&coords).unwrap(), expected);
    });
}
