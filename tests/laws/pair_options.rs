//! Options of single pairs: every pair is what it would be in a problem of its own.

use crate::scene::table::exactly;
use crate::scene::{Scene, distance, exact, fibers, isotropic, lines, size_sum};
use crate::tangent::deviation;
use fmc_contact::contact::{PairOptions, TangentPart};
use fmc_contact::overlap::Partner::{self, Body, Obstacle as Rigid};
use fmc_contact::{Contact, ContactForces, EnergyLaw, Error, FiberOptions, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Mesh, cuboid_tet4, random_polygon, random_polyhedron, rectangle_quad4};

/// Three bodies, each of which overlaps both others.
fn plane_trio() -> [Mesh<2>; 3] {
    let at = |seed, place| random_polygon(9, 0.8, 0.3, seed).translated(place);
    [at(1, [0.0, 0.0]), at(2, [0.9, 0.1]), at(3, [0.4, 0.8])]
}

fn solid_trio() -> [Mesh<3>; 3] {
    let at = |seed, place| random_polyhedron(0, 0.8, 0.3, 2, seed).translated(place);
    [at(1, [0.0, 0.0, 0.0]), at(2, [0.7, 0.1, 0.1]), at(3, [0.3, 0.6, 0.2])]
}

/// A plane below all three bodies, which reaches into them.
fn floor<const D: usize>() -> Obstacle<D> {
    Obstacle { shape: Shape::HalfSpace, pose: Pose::at(std::array::from_fn(|i| if i + 1 == D { -0.3 } else { 0.0 })) }
}

fn with_law(law: EnergyLaw) -> Option<PairOptions> {
    Some(PairOptions::with_law(law))
}

fn contact<const D: usize>(
    scene: &Scene<D>,
    options: Options,
    pairs: &[([Partner; 2], Option<PairOptions>)],
) -> Contact<D> {
    let mut contact = scene.contact(options);
    contact.add_obstacle(floor()).unwrap();
    pairs.iter().for_each(|(partners, options)| contact.set_pair_options(*partners, *options).unwrap());
    contact
}

/// A displacement.
fn field<const D: usize>(coords: &[[f64; D]]) -> Vec<[f64; D]> {
    coords.iter().map(|x| x.map(|of_axis| (5.0 * of_axis + 2.0 * x.iter().sum::<f64>()).sin())).collect()
}

/// What the problems of some of the bodies, without the plane or with it alone, add up to.
struct Sum<const D: usize> {
    forces: Vec<[f64; D]>,
    energy: f64,
    pair_count: usize,
    /// Products of the tangents with the displacement.
    products: Vec<Vec<[f64; D]>>,
}

fn sum<const D: usize>(bodies: &[Mesh<D>; 3], problems: &[(&[usize], bool, Options)]) -> Sum<D> {
    let scene = Scene::of(&bodies.each_ref());
    let forces = vec![[0.0; D]; scene.coords.len()];
    let mut sum = Sum { forces, energy: 0.0, pair_count: 0, products: Vec::new() };
    for (chosen, has_floor, options) in problems {
        let some = Scene::of(&chosen.iter().map(|&body| &bodies[body]).collect::<Vec<_>>());
        let mut contact = some.contact(*options);
        if *has_floor {
            contact.add_obstacle(floor()).unwrap();
        }
        let found = contact.evaluate(&some.coords).unwrap();
        let tangent = contact.tangent(&some.coords, TangentPart::Semidefinite).unwrap();
        let product = tangent.product(&field(&some.coords));
        let mut all = vec![[0.0; D]; scene.coords.len()];
        for (place, &body) in chosen.iter().enumerate() {
            for (n, m) in scene.nodes_of(body).zip(some.nodes_of(place)) {
                (0..D).for_each(|i| sum.forces[n][i] += found.forces[m][i]);
                all[n] = product[m];
            }
        }
        sum.products.push(all);
        sum.energy += found.energy;
        sum.pair_count += found.pairs.len();
    }
    sum
}

fn is_sum<const D: usize>(
    contact: &Contact<D>,
    bodies: &[Mesh<D>; 3],
    problems: &[(&[usize], bool, Options)],
) -> ContactForces<D> {
    let scene = Scene::of(&bodies.each_ref());
    let found = contact.evaluate(&scene.coords).unwrap();
    let Sum { forces, energy, pair_count, products } = sum(bodies, problems);
    assert!(energy > 0.0 && found.pairs.len() == pair_count, "{} pairs, {pair_count} alone", found.pairs.len());
    assert!((found.energy - energy).abs() <= 1e-14 * energy, "{} {energy}", found.energy);
    let off = distance(&found.forces, &forces) / size_sum(&forces);
    assert!(off < 1e-14, "{off:e}");
    let product = contact.tangent(&scene.coords, TangentPart::Semidefinite).unwrap().product(&field(&scene.coords));
    let mut expected = vec![[0.0; D]; product.len()];
    for alone in &products {
        expected.iter_mut().flatten().zip(alone.iter().flatten()).for_each(|(sum, x)| *sum += x);
    }
    let off = distance(&product, &expected) / products.iter().map(|x| size_sum(x)).sum::<f64>();
    assert!(off < 1e-13, "tangent: {off:e}; {problems:?}");
    found
}

fn laws() -> [fn(f64) -> EnergyLaw; 3] {
    [|k| EnergyLaw::Volume { stiffness: k, exponent: 2.0 }, EnergyLaw::fiber, EnergyLaw::depth]
}

fn three_stiffnesses<const D: usize>(bodies: &[Mesh<D>; 3], spacing: f64) {
    let scene = Scene::of(&bodies.each_ref());
    for law in laws() {
        for estimator in [exact(), lines(spacing, 3), fibers(FiberOptions::default())] {
            let of = |k: f64| Options { law: law(k), ..estimator };
            // One pair follows the default, and bodies are named in either order.
            let pairs =
                [([Body(0), Body(1)], with_law(law(7.0))), ([Body(2), Body(1)], with_law(law(0.3)))].into_iter();
            let apart = (0..3).map(|body| ([Rigid(0), Body(body)], Some(PairOptions::excluded())));
            let contact = contact(&scene, of(2.0), &pairs.chain(apart).collect::<Vec<_>>());
            let problems: [(&[usize], bool, Options); 3] =
                [(&[0, 1], false, of(7.0)), (&[1, 2], false, of(0.3)), (&[0, 2], false, of(2.0))];
            is_sum(&contact, bodies, &problems);
        }
    }
}

#[test]
fn three_stiffnesses_are_three_problems() {
    three_stiffnesses(&plane_trio(), 0.01);
    three_stiffnesses(&solid_trio(), 0.05);
}

fn laws_of_pairs<const D: usize>(bodies: &[Mesh<D>; 3]) {
    let [volume, fiber, depth] = laws().map(|law| law(3.0));
    // The default on the plane, and another law on each pair of bodies; every law is the default once.
    for [first, second, third] in [[volume, depth, fiber], [fiber, volume, depth], [depth, fiber, volume]] {
        let pairs = [
            ([Body(0), Body(1)], with_law(second)),
            ([Body(1), Body(2)], with_law(third)),
            ([Body(0), Body(2)], Some(PairOptions::excluded())),
            ([Body(1), Rigid(0)], Some(PairOptions::excluded())),
            ([Body(2), Rigid(0)], with_law(third)),
        ];
        let scene = Scene::of(&bodies.each_ref());
        let contact = contact(&scene, exactly(first), &pairs);
        let problems: [(&[usize], bool, Options); 4] = [
            (&[0], true, exactly(first)),
            (&[0, 1], false, exactly(second)),
            (&[1, 2], false, exactly(third)),
            (&[2], true, exactly(third)),
        ];
        let found = is_sum(&contact, bodies, &problems);
        let both = contact.evaluate_tangent(&scene.coords, TangentPart::Full).unwrap();
        assert_eq!(both.0, found);
        assert_eq!(both.1, contact.tangent(&scene.coords, TangentPart::Full).unwrap());
        // Local laws have contact points.
        let points = contact.contact_points(&scene.coords).unwrap();
        assert!(!points.is_empty());
        for point in points {
            let [a, b] = point.partners;
            let pair = contact.pair_options([b, a]).unwrap().unwrap_or_default();
            assert!(!pair.excluded && pair.law.unwrap_or(first) != volume, "{:?}", point.partners);
        }
        // Pressure, area and normal at the nodes have the resultants, whichever laws meet at a node.
        let nodal = contact.nodal_contact(&scene.coords).unwrap();
        for (body, resultant) in found.bodies.iter().enumerate() {
            for axis in 0..D {
                let at = |n: usize| -nodal.pressure[n] * nodal.area[n] * nodal.normal[n][axis];
                let off = scene.nodes_of(body).map(at).sum::<f64>() - resultant.force[axis];
                assert!(off.abs() < 1e-12 * size_sum(&found.forces), "body {body}: {off:e}");
            }
        }
    }
}

#[test]
fn every_pair_may_have_its_law() {
    laws_of_pairs(&plane_trio());
    laws_of_pairs(&solid_trio());
}

/// All results of a contact, to the bit.
fn all<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> String {
    let tangent = contact.tangent(coords, TangentPart::Full).unwrap();
    let (points, lines) = (contact.contact_points(coords).unwrap(), contact.trace(coords).unwrap());
    let (overlaps, nodal) = (contact.overlaps(coords).unwrap(), contact.nodal_contact(coords).unwrap());
    format!("{:?} {tangent:?} {points:?} {lines:?} {overlaps:?} {nodal:?}", contact.evaluate(coords).unwrap())
}

#[test]
fn a_body_left_out_of_all_pairs_is_not_there() {
    let bodies = plane_trio();
    let (scene, fewer) = (Scene::of(&bodies.each_ref()), Scene::of(&[&bodies[0], &bodies[1]]));
    for options in [exact(), lines(0.01, 1), Options { law: EnergyLaw::fiber(2.0), ..exact() }] {
        let out = |partner| ([partner, Body(2)], Some(PairOptions::excluded()));
        let found = contact(&scene, options, &[out(Body(0)), out(Body(1)), out(Rigid(0))]);
        let found = found.evaluate(&scene.coords).unwrap();
        let expected = contact(&fewer, options, &[]).evaluate(&fewer.coords).unwrap();
        let (seen, other) = found.forces.split_at(fewer.coords.len());
        assert_eq!(seen, expected.forces);
        assert!(expected.pairs.len() == 3 && other.iter().all(|force| *force == [0.0; 2]));
        assert_eq!((&found.pairs, &found.obstacles), (&expected.pairs, &expected.obstacles));
        assert_eq!(
            (found.energy, found.volume, found.fiber_count),
            (expected.energy, expected.volume, expected.fiber_count)
        );
    }
}

/// A pair that is measured no more asks for nothing: here for a law that the estimator does not support.
#[test]
fn what_is_left_out_is_not_measured() {
    let scene = Scene::of(&plane_trio().each_ref());
    let mut contact = scene.contact(exact());
    let ball = contact.add_obstacle(Obstacle { shape: Shape::Ball { radius: 0.5 }, pose: Pose::at([0.0; 2]) }).unwrap();
    assert!(matches!(contact.evaluate(&scene.coords), Err(Error::Unsupported { .. })));
    for body in 0..3 {
        contact.set_pair_options([Rigid(ball), Body(body)], Some(PairOptions::excluded())).unwrap();
    }
    assert_eq!(contact.evaluate(&scene.coords).unwrap().pairs.len(), 3);
}

#[test]
fn a_pair_with_the_default_options_has_the_default_bits() {
    let bodies = plane_trio();
    let scene = Scene::of(&bodies.each_ref());
    for law in laws().map(|law| law(3.0)) {
        for threads in [1, 3] {
            let options = Options { threads, ..exactly(law) };
            let mut contact = contact(&scene, options, &[]);
            let expected = all(&contact, &scene.coords);
            for pair in [[Body(0), Body(1)], [Body(1), Body(2)], [Body(0), Rigid(0)]] {
                for options in [with_law(law), Some(PairOptions::default())] {
                    contact.set_pair_options(pair, options).unwrap();
                    assert_eq!(all(&contact, &scene.coords), expected, "{pair:?}: {options:?}");
                }
                // Another law, and back: what was found under it is forgotten.
                contact.set_pair_options(pair, with_law(EnergyLaw::volume(9.0))).unwrap();
                assert!(contact.evaluate(&scene.coords).unwrap().energy > 0.0);
                contact.set_pair_options([pair[1], pair[0]], None).unwrap();
                assert_eq!(contact.pair_options(pair).unwrap(), None);
                assert_eq!(all(&contact, &scene.coords), expected, "{pair:?}");
            }
        }
    }
}

/// Two bodies, each in two parts that overlap.
#[test]
fn self_contact_is_switched_body_by_body() {
    let part = |x: f64, y: f64| rectangle_quad4([x, y], [x + 1.0, y + 1.0], [3, 3]);
    let scene = |ids: [i64; 4]| {
        let places = [(0.0, 0.0), (0.1, 0.9), (5.0, 0.0), (5.2, 0.8)];
        places.iter().zip(ids).fold(Scene::new(), |scene, (&(x, y), id)| scene.with(&part(x, y), id))
    };
    let itself = |body| [Body(body); 2];
    let options = |self_contact| Options { self_contact, ..exact() };
    let both = scene([0, 0, 1, 1]);
    // Only the second body in two parts; the first is two bodies that are left out of one another.
    let on = contact(&both, options(false), &[(itself(1), Some(PairOptions::default()))]);
    let off = contact(&both, options(true), &[(itself(0), Some(PairOptions::excluded()))]);
    let [on, off] = [on, off].map(|contact| contact.evaluate(&both.coords).unwrap());
    assert_eq!(on, off);
    assert!((on.volume - 0.8 * 0.2 - contact_volume(&both, false)).abs() < 1e-12, "{}", on.volume);
    // With both switched on.
    assert!((contact_volume(&both, true) - contact_volume(&both, false) - 0.8 * 0.2 - 0.9 * 0.1).abs() < 1e-12);
}

/// Overlap of the scene with the floor, and with itself.
fn contact_volume(scene: &Scene<2>, self_contact: bool) -> f64 {
    contact(scene, Options { self_contact, ..exact() }, &[]).evaluate(&scene.coords).unwrap().volume
}

/// Depth on one pair, lines along the normal on another, the overlap volume against a plane.
fn mixed_tangent<const D: usize>(bodies: &[Mesh<D>; 3], every: usize) {
    let scene = Scene::of(&bodies.each_ref());
    let volume = EnergyLaw::Volume { stiffness: 4.0, exponent: 2.0 };
    let mut contact = scene.contact(exactly(volume));
    let mut pose = Pose::at(std::array::from_fn(|i| if i + 1 == D { 1.45 } else { 0.0 }));
    // Turned over, and tilted.
    let (sin, cos) = (std::f64::consts::PI - 0.03).sin_cos();
    pose.rotation[0][0] = cos;
    pose.rotation[0][D - 1] = -sin;
    pose.rotation[D - 1][0] = sin;
    pose.rotation[D - 1][D - 1] = cos;
    let roof = contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose }).unwrap();
    contact.set_pair_options([Body(2), Body(0)], with_law(EnergyLaw::depth(5.0))).unwrap();
    contact.set_pair_options([Body(0), Body(1)], with_law(EnergyLaw::fiber(3.0))).unwrap();
    contact.set_pair_options([Body(2), Rigid(roof)], with_law(EnergyLaw::depth(2.0))).unwrap();
    assert_eq!(contact.keep_patches(&scene.coords).unwrap(), 1);
    assert_eq!(contact.evaluate(&scene.coords).unwrap().pairs.len(), 4);
    let found = deviation(&contact, &scene.coords, 1.0, every);
    assert!(found < 1e-6, "{found:e}");
}

#[test]
fn the_tangent_of_mixed_laws_is_the_derivative_of_the_force() {
    mixed_tangent(
        &[
            rectangle_quad4([0.0, 0.0], [2.0, 1.0], [8, 4]),
            rectangle_quad4([0.2, 0.95], [0.8, 1.5], [3, 3]).rotated(0.02),
            rectangle_quad4([1.1, 0.93], [1.7, 1.6], [4, 3]).rotated(-0.01),
        ],
        1,
    );
    mixed_tangent(
        &[
            cuboid_tet4([0.0, 0.0, 0.0], [2.0, 1.0, 1.0], [4, 2, 2]),
            cuboid_tet4([0.2, 0.2, 0.95], [0.8, 0.8, 1.5], [2, 2, 2]).rotated([0.3, 1.0, 0.1], -0.02),
            cuboid_tet4([1.1, 0.2, 0.93], [1.7, 0.7, 1.6], [2, 2, 2]).rotated([0.2, 1.0, 0.3], 0.01),
        ],
        5,
    );
}

#[test]
fn what_is_refused_changes_nothing() {
    let scene = Scene::of(&plane_trio().each_ref());
    let options = Options { law: EnergyLaw::fiber(2.0), ..fibers(FiberOptions::default()) };
    let own = with_law(EnergyLaw::fiber(7.0));
    let mut contact = contact(&scene, options, &[([Body(1), Body(0)], own)]);
    let before = all(&contact, &scene.coords);
    let mut refused = |partners, options| {
        let error = contact.set_pair_options(partners, options).unwrap_err();
        assert_eq!(contact.pair_options([Body(0), Body(1)]).unwrap(), own);
        assert_eq!(all(&contact, &scene.coords), before);
        (error.to_string(), error)
    };
    for options in [None, Some(PairOptions::excluded())] {
        assert_eq!(refused([Body(0), Body(3)], options).1, Error::BodyOutOfRange { body: 3, count: 3 });
        assert_eq!(refused([Rigid(1), Body(0)], options).1, Error::ObstacleOutOfRange { obstacle: 1, count: 1 });
        assert!(matches!(refused([Rigid(0), Rigid(0)], options).1, Error::Unsupported { .. }));
    }
    for stiffness in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
        let text = refused([Rigid(0), Body(1)], with_law(EnergyLaw::fiber(stiffness))).0;
        assert!(text.starts_with("pair of body 1 and obstacle 0: 'stiffness' is "), "{text}");
    }
    let (text, error) = refused([Body(1), Body(0)], with_law(EnergyLaw::Volume { stiffness: 1.0, exponent: 0.5 }));
    assert_eq!(text, "pair of body 0 and body 1: 'exponent' is 0.5, which is not allowed");
    assert!(matches!(error, Error::OfPair { sides: [("body", 0), ("body", 1)], .. }));
    // A law that the estimator of all does not support, and the other way round.
    contact.set_options(isotropic(0.3, 500, 1)).unwrap_err();
    contact.set_pair_options([Body(1), Body(0)], with_law(EnergyLaw::volume(7.0))).unwrap();
    contact.set_options(isotropic(0.3, 500, 1)).unwrap();
    let before = contact.evaluate(&scene.coords).unwrap();
    let error = contact.set_pair_options([Body(2), Body(2)], with_law(EnergyLaw::fiber(1.0))).unwrap_err();
    let text = error.to_string();
    assert!(text.starts_with("pair of body 2 and body 2: not supported: the fiber law on isotropic fibers"), "{text}");
    assert_eq!(contact.evaluate(&scene.coords).unwrap(), before);
    contact.set_options(exactly(EnergyLaw::fiber(2.0))).unwrap();
    contact.set_pair_options([Body(2), Body(1)], with_law(EnergyLaw::fiber(1.0))).unwrap();
    let before = all(&contact, &scene.coords);
    let refused = contact.set_options(isotropic(0.3, 500, 1)).unwrap_err().to_string();
    assert!(refused.starts_with("pair of body 1 and body 2: not supported: the fiber law on isotropic"), "{refused}");
    assert_eq!(contact.options(), &exactly(EnergyLaw::fiber(2.0)));
    assert_eq!(all(&contact, &scene.coords), before);
    assert!(contact.pair_options([Body(9), Body(0)]).is_err());
}
