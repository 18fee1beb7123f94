//! Obstacles with temperatures.

use crate::scene::Scene;
use crate::{K, dot, largest};
use fmc_contact::contact::{Conductance, ContactFlux, FluxRequest};
use fmc_contact::{EnergyLaw, Obstacle, Options, Pose, Shape};
use fmc_shapes::{cuboid_tet4, rectangle_quad4};

fn with_obstacle<const D: usize>(
    scene: &Scene<D>,
    (shape, pose): (Shape<D>, Pose<D>),
    (law, h): (EnergyLaw, &Conductance),
    (field, at): (&[f64], &[f64]),
) -> ContactFlux {
    let mut contact = scene.contact(Options::new(law));
    contact.add_obstacle(Obstacle { shape, pose }).expect("an obstacle");
    contact.flux(&scene.coords, &FluxRequest { fields: field, of_obstacles: Some(at), conductance: h }).expect("a flux")
}

/// A block on a half-space, which is a box, too: pressed, and at a distance.
#[test]
fn a_block_on_a_plate() {
    let tables = Conductance { by_pressure: vec![[0.0, 1.0], [2.0, 5.0]], by_gap: vec![[0.0, 1.0], [0.1, 0.5]] };
    let shapes = || [(Shape::HalfSpace, 0.0), (Shape::Cuboid { half_extents: [5.0, 5.0, 1.0] }, -1.0)];
    for (gap, h) in [(-0.01, 3.0), (0.05, 0.75), (0.11, 0.0)] {
        for (shape, z) in shapes() {
            let scene = Scene::of(&[&cuboid_tet4([0.1, 0.2, gap], [1.1, 0.7, 1.0], [2, 3, 2])]);
            let values: Vec<f64> = scene.coords.iter().map(|x| 10.0 + x[0]).collect();
            let at = Pose::at([0.0, 0.0, z]);
            let found = with_obstacle(&scene, (shape, at), (EnergyLaw::depth(K), &tables), (&values, &[4.0]));
            let expected = h * 0.5 * 6.6;
            assert!((found.of_obstacles[0] + expected).abs() < 1e-12);
            assert!((found.flux.iter().sum::<f64>() - expected).abs() < 1e-12);
            // ∫ h (6 + x)(10 + x) dA over x from 0.1 to 1.1, 0.5 wide.
            let power = 0.5 * h * (60.0 + 16.0 * 0.6 + (1.1f64.powi(3) - 0.1f64.powi(3)) / 3.0);
            assert!((dot(&values, &found.flux) - power).abs() < 1e-11);
            // The same temperature everywhere.
            let equal = with_obstacle(
                &scene,
                (Shape::HalfSpace, Pose::at([0.0; 3])),
                (EnergyLaw::depth(K), &tables),
                (&vec![7.0; values.len()], &[7.0]),
            );
            assert!(equal.flux.iter().chain(&equal.of_obstacles).all(|q| *q == 0.0));
            let size = scene.coords.len() + 1;
            assert_eq!(found.matrix.offsets.len(), size + 1);
        }
    }
}

/// Of a block that is tilted a part is pressed: facets are cut where the distance is zero.
#[test]
fn a_tilted_block_conducts_where_it_is_pressed() {
    let scene =
        Scene::of(&[&rectangle_quad4([0.0, 0.0], [1.0, 1.0], [3, 2])]).mapped(|[x, y]| [x, y + 0.02 * (x - 0.4)]);
    let values = vec![2.0; scene.coords.len()];
    for law in [EnergyLaw::depth(K), EnergyLaw::fiber(K)] {
        let half_space = (Shape::HalfSpace, Pose::at([0.0, 0.0]));
        let found = with_obstacle(&scene, half_space, (law, &Conductance::constant(5.0)), (&values, &[1.0]));
        let expected = 5.0 * 0.4 * 0.02f64.hypot(1.0);
        assert!((found.of_obstacles[0] + expected).abs() < 1e-12, "{}", found.of_obstacles[0] + expected);
        // Pressures from K · 0.008 down to 0: means of a table that is linear.
        let h = Conductance { by_pressure: vec![[0.0, 0.0], [1.0, 1.0]], by_gap: Vec::new() };
        let half_space = (Shape::HalfSpace, Pose::at([0.0, 0.0]));
        let found = with_obstacle(&scene, half_space, (law, &h), (&values, &[1.0]));
        let expected = 0.5 * 0.008 * K * 0.4 * 0.02f64.hypot(1.0);
        assert!((found.of_obstacles[0] / -expected - 1.0).abs() < 1e-3, "{law:?}");
    }
}

/// A ball pressed into a block, in 2D a disc: the width of the contact, to second order.
#[test]
fn a_disc_in_a_block() {
    let off = |cells: usize| {
        let scene = Scene::of(&[&rectangle_quad4([-1.0, -1.0], [1.0, 0.0], [cells, 2])]);
        let values = vec![3.0; scene.coords.len()];
        let disc = (Shape::Ball { radius: 1.0 }, Pose::at([0.0, 0.9]));
        let found = with_obstacle(&scene, disc, (EnergyLaw::depth(K), &Conductance::constant(2.0)), (&values, &[1.0]));
        let width = 2.0 * (1.0f64 - 0.81).sqrt();
        (found.of_obstacles[0] / (-4.0 * width) - 1.0).abs()
    };
    assert!(off(40) < 2e-3 && off(160) < 2e-4, "{:e} {:e}", off(40), off(160));
}

/// Without temperatures obstacles take no heat; with several fields each has its own.
#[test]
fn obstacles_without_values_are_insulated() {
    let scene = Scene::of(&[&rectangle_quad4([0.0, -0.01], [1.0, 1.0], [3, 2])]);
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 0.0]) }).expect("an obstacle");
    let h = Conductance::constant(2.0);
    let fields: Vec<f64> = scene.coords.iter().map(|_| 1.0).chain(scene.coords.iter().map(|_| 5.0)).collect();
    let request = FluxRequest { fields: &fields, of_obstacles: None, conductance: &h };
    let none = contact.flux(&scene.coords, &request).expect("a flux");
    assert!(largest(&none.flux) == 0.0 && none.matrix.values.is_empty());
    let request = FluxRequest { of_obstacles: Some(&[0.0, 3.0]), ..request };
    let found = contact.flux(&scene.coords, &request).expect("a flux");
    assert!(found.of_obstacles.iter().zip([-2.0, -4.0]).all(|(q, expected)| (q - expected).abs() < 1e-13));
}
