//! Friction of rings: within the plane of r and z, on their areas of revolution.

use crate::scene::Scene;
use crate::{depth, exactly};
use fmc_contact::contact::{Friction, TangentPart};
use fmc_contact::{Contact, EnergyLaw, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Diagonals, Splitmix, rectangle_quad4, rectangle_tri3};
use std::f64::consts::PI;

const K: f64 = 1e4;
const MU: f64 = 0.3;

fn rough() -> Options {
    Options { friction: Friction::coulomb(MU), ..depth(K) }
}

/// Every node of one mesh of a scene moved by (r, z).
fn moved(scene: &Scene<2>, mesh: usize, by: [f64; 2]) -> Vec<[f64; 2]> {
    let mut coords = scene.coords.clone();
    scene.nodes_of(mesh).for_each(|node| (0..2).for_each(|i| coords[node][i] += by[i]));
    coords
}

/// A flat ring that grows on a plane: the bottom slides, and holds back by μ k δ 2πr; or sticks, by k s 2πr. The walls,
/// sunk in by δ, do not face the plane and have no friction worth naming.
#[test]
fn a_ring_that_grows_on_a_plane() {
    let (inner, outer, delta) = (0.7, 1.0, 1e-3);
    let area = PI * (outer * outer - inner * inner);
    for mesh in [
        rectangle_tri3([inner, 0.0], [outer, 0.5], [40, 3], Diagonals::Alternating),
        rectangle_quad4([inner, 0.0], [outer, 0.5], [30, 2]),
    ] {
        let scene = Scene::of(&[&mesh]);
        let mut contact = scene.contact(rough());
        contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, delta]) }).unwrap();
        contact.begin_step(&scene.coords).unwrap();
        for (slip, traction) in [(1e-5, K * 1e-5), (1e-2, MU * K * delta)] {
            let found = contact.evaluate(&moved(&scene, 0, [slip, 0.0])).unwrap();
            let now = area + 2.0 * PI * slip * (outer - inner);
            let ratio = -found.bodies[0].friction[0] / (traction * now);
            assert!((ratio - 1.0).abs() < 2e-2, "slip {slip}: {ratio}");
            let (stick, slides) = (found.friction.stick_area / now, found.friction.slip_area / now);
            assert!((stick + slides - 1.0).abs() < 2e-2, "{stick} {slides}");
        }
    }
}

/// A shaft pulled out of a hub that grips it: μ k δ on half of either's cylinder, along the axis, all of it taken out as heat.
#[test]
fn a_shaft_pulled_out_of_a_hub() {
    let (radius, delta, length) = (0.5, 1e-3, 1.0);
    let shaft = rectangle_quad4([0.0, 0.0], [radius + delta, length], [3, 20]);
    let hub = rectangle_tri3([radius, -0.5], [1.2, length + 0.5], [4, 31], Diagonals::Alternating);
    let scene = Scene::of(&[&shaft, &hub]);
    for law in [EnergyLaw::depth(K), EnergyLaw::fiber(K)] {
        pulled_by(&scene, law, (radius, delta, length));
    }
}

fn pulled_by(scene: &Scene<2>, law: EnergyLaw, (radius, delta, length): (f64, f64, f64)) {
    let mut contact = scene.contact(Options { friction: Friction::coulomb(MU), ..exactly(law) });
    contact.begin_step(&scene.coords).unwrap();
    let pulled = 0.02;
    let found = contact.evaluate(&moved(scene, 0, [0.0, pulled])).unwrap();
    let limit = MU * K * delta * PI * (2.0 * radius + delta) * length;
    let ratio = -found.bodies[0].friction[1] / limit;
    // The ends of the shaft, δ high, bear less.
    assert!((ratio - 1.0).abs() < 3.0 * delta / length, "{law:?}: {ratio}");
    let balance = found.bodies[0].friction[1] + found.bodies[1].friction[1];
    assert!(balance.abs() < 1e-12 * limit, "{balance}");
    let elastic = MU * delta; // At a stick of k
    let heat = found.friction.dissipated / (limit * (pulled - elastic));
    assert!((heat - 1.0).abs() < 5e-3, "{heat}");
}

/// What the tangent leaves out, the growth of rings that move outwards among it, is of the size of the penetration by
/// that of facets, and by the radius.
#[test]
fn tangent_against_differences() {
    for delta in [1e-3, 1e-4] {
        tangent_at(delta);
    }
}

fn tangent_at(delta: f64) {
    let (facet, radius) = (0.225, 0.5);
    let lower = rectangle_tri3([0.2, -0.5], [2.0, 0.0], [6, 2], Diagonals::Alternating);
    let upper = rectangle_quad4([0.5, -delta], [1.4, 0.6], [4, 2]);
    let scene = Scene::of(&[&lower, &upper]);
    let begun = |options: Options| -> Contact<2> {
        let mut contact = scene.contact(options);
        contact.begin_step(&scene.coords).unwrap();
        contact
    };
    let (rough, smooth) = (begun(rough()), begun(depth(K)));
    for slip in [0.1 * delta, delta] {
        let mut random = Splitmix::new(3);
        let mut coords = moved(&scene, 1, [slip, 0.0]);
        coords.iter_mut().flatten().for_each(|x| *x += 0.05 * delta * random.between(-1.0, 1.0));
        let direction: Vec<[f64; 2]> = coords.iter().map(|_| [(); 2].map(|()| random.between(-1.0, 1.0))).collect();
        let step = 1e-5 * delta;
        let force = |h: f64| {
            let at: Vec<[f64; 2]> =
                coords.iter().zip(&direction).map(|(x, d)| [x[0] + h * d[0], x[1] + h * d[1]]).collect();
            let (with, without) = (rough.evaluate(&at).unwrap().forces, smooth.evaluate(&at).unwrap().forces);
            with.into_iter().flatten().zip(without.into_iter().flatten()).map(|(f, g)| f - g).collect::<Vec<f64>>()
        };
        let product = |contact: &Contact<2>| contact.tangent(&coords, TangentPart::Full).unwrap().product(&direction);
        let products: Vec<f64> = (product(&rough).into_iter().flatten().zip(product(&smooth).into_iter().flatten()))
            .map(|(p, q)| p - q)
            .collect();
        let largest = products.iter().fold(0.0f64, |most, p| most.max(p.abs()));
        for ((plus, minus), product) in force(step).iter().zip(force(-step)).zip(&products) {
            let error = ((minus - plus) / (2.0 * step) - product).abs() / largest;
            assert!(error < 2.0 * delta * (1.0 / facet + 1.0 / radius), "slip {slip}: {error}");
        }
    }
}
