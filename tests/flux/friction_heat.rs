//! The heat of friction: what is dissipated, all of it.

use crate::K;
use crate::scene::Scene;
use fmc_contact::contact::Friction;
use fmc_contact::{Contact, EnergyLaw, Error, Obstacle, Options, Pose, Shape};
use fmc_shapes::{cuboid_hex8, rectangle_quad4, second_order};

fn options(law: EnergyLaw) -> Options {
    Options { friction: Friction::coulomb(0.3), ..Options::new(law) }
}

/// A smaller block on a larger one, moved with all its nodes; steps are accepted as they come.
fn slides<const D: usize>(scene: &Scene<D>, law: EnergyLaw, freeze: bool) {
    let mut contact = scene.contact(options(law));
    let at = |by: [f64; 2]| -> Vec<[f64; D]> {
        let upper = |node: usize| f64::from(u8::from(node >= scene.first_node[1]));
        let moved = |(node, x): (usize, &[f64; D])| {
            let mut x = *x;
            (x[0], x[D - 1]) = (x[0] + by[0] * upper(node), x[D - 1] + by[1] * upper(node));
            x
        };
        scene.coords.iter().enumerate().map(moved).collect()
    };
    contact.begin_step(&at([0.0, 0.0])).expect("a step");
    // It slides, sticks, slides back and is lifted off.
    for by in [[0.03, 0.0], [0.07, -0.002], [0.069, -0.002], [0.05, 0.002], [0.052, 0.1]] {
        let coords = at(by);
        if freeze {
            contact.freeze_friction(&coords).expect("friction");
        }
        check(&contact, &coords, scene);
        contact.commit_step(&coords).expect("a step");
    }
}

fn check<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], scene: &Scene<D>) {
    let dissipated = contact.evaluate(coords).expect("forces").friction.dissipated;
    for effusivities in [None, Some([1.0, 3.0]), Some([0.0, 2.0])] {
        let found = contact.friction_heat(coords, effusivities.as_ref().map(|e| &e[..])).expect("heat");
        let sums = [0, 1].map(|mesh| found.nodes[scene.nodes_of(mesh)].iter().sum::<f64>());
        assert!((sums[0] + sums[1] - dissipated).abs() <= 1e-12 * dissipated, "{sums:?} {dissipated}");
        let [a, b] = effusivities.unwrap_or([1.0, 1.0]);
        // What a pair had stored as it left the contact stays on the facets that held it.
        let is_apart = contact.evaluate(coords).expect("forces").contact_area == 0.0;
        assert!(is_apart || (sums[0] * b - sums[1] * a).abs() <= 1e-12 * dissipated, "{sums:?}");
        assert!(found.of_obstacles.is_empty());
        // Shape functions of second order are negative at places.
        let is_straight = scene.blocks.iter().all(|(cell_type, _)| cell_type.straight() == *cell_type);
        assert!(!is_straight || found.nodes.iter().all(|heat| *heat >= 0.0));
    }
}

#[test]
fn heat_is_what_is_dissipated() {
    let (below, above) =
        (rectangle_quad4([0.0, 0.0], [2.0, 0.5], [5, 1]), rectangle_quad4([0.4, 0.48], [1.3, 1.0], [3, 1]));
    let flat = Scene::of(&[&below, &above]);
    for law in [EnergyLaw::depth(K), EnergyLaw::fiber(K), EnergyLaw::depth(10.0 * K)] {
        slides(&flat, law, false);
    }
    slides(&flat, EnergyLaw::depth(K), true);
    slides(&Scene::of(&[&second_order(&below, 8), &above]), EnergyLaw::depth(K), false);
    let below = cuboid_hex8([0.0; 3], [2.0, 1.0, 0.5], [3, 2, 1]);
    let above = cuboid_hex8([0.4, 0.2, 0.48], [1.3, 0.9, 1.0], [2, 2, 1]);
    slides(&Scene::of(&[&below, &above]), EnergyLaw::depth(K), false);
}

/// A block on a plate that is drawn away: μ p times area and way, but for the way to the limit.
#[test]
fn a_plate_takes_its_part() {
    let scene = Scene::of(&[&rectangle_quad4([0.0, -0.01], [1.0, 1.0], [3, 2])]);
    let mut contact = scene.contact(options(EnergyLaw::depth(K)));
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 0.0]) }).expect("an obstacle");
    contact.begin_step(&scene.coords).expect("a step");
    contact.set_pose(0, Pose::at([0.5, 0.0])).expect("an obstacle");
    let found = contact.friction_heat(&scene.coords, Some(&[1.0, 4.0])).expect("heat");
    let pressure = K * 0.01;
    // The stick gives way by μ p/K.
    let expected = 0.3 * pressure * (0.5 - 0.3 * pressure / K);
    assert!((found.of_obstacles[0] - 0.8 * expected).abs() < 1e-12, "{found:?}");
    assert!((found.nodes.iter().sum::<f64>() - 0.2 * expected).abs() < 1e-12);
    let bad = |given: &[f64]| contact.friction_heat(&scene.coords, Some(given));
    assert_eq!(bad(&[1.0]), Err(Error::Length { array: "effusivities", expected: 2, found: 1 }));
    assert_eq!(bad(&[1.0, -1.0]), Err(Error::BadEntry { array: "effusivities", entry: 1, value: -1.0 }));
    let none = scene.contact(options(EnergyLaw::depth(K)));
    assert_eq!(none.friction_heat(&scene.coords, None), Err(Error::NoStep));
}
