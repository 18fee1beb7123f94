//! A body that has moved away as a whole pulls evenly: every node bears its share by the shape functions.

use crate::blocks::rectangles;
use crate::scene::Scene;
use crate::{K, tied};
use fmc_contact::contact::PairOptions;
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{EnergyLaw, Options};
use fmc_shapes::{cuboid_hex8, rectangle_quad4, second_order};
use std::f64::consts::TAU;

const BY: [f64; 2] = [0.003, 0.001];

/// Forces by K and the jump, of the nodes at a height, by their first coordinate.
fn shares(scene: &Scene<2>, body: usize, height: f64) -> Vec<(f64, f64)> {
    let contact = tied(scene, 0.0);
    let start = scene.first_node[1];
    let mut coords = scene.coords.clone();
    coords[start..].iter_mut().for_each(|x| (0..2).for_each(|axis| x[axis] += BY[axis]));
    let forces = contact.evaluate(&coords).expect("an evaluation").forces;
    let range = if body == 0 { 0..start } else { start..coords.len() };
    let sign = if body == 0 { 1.0 } else { -1.0 };
    let at_height = range.filter(|&node| scene.coords[node][1] == height);
    let mut found: Vec<_> = at_height
        .map(|node| {
            // Both components say the same.
            assert!((forces[node][0] / BY[0] - forces[node][1] / BY[1]).abs() < 1e-9 * K);
            (scene.coords[node][0], sign * forces[node][0] / (K * BY[0]))
        })
        .collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
}

/// Shares of nodes of an edge of length h: 1/2, 1/2, or 1/6, 2/3, 1/6. Rounding of coordinates of 1 over a jump of 1e-3 is 1e-13.
#[test]
fn every_node_has_its_share() {
    for first in 0..5 {
        for second in 0..5 {
            let below = &rectangles([0.0, 0.0], [1.0, 0.5], [2, 1])[first];
            let above = &rectangles([0.0, 0.5], [1.0, 1.0], [3, 1])[second];
            let scene = Scene::of(&[below, above]);
            for (body, edges, of_type) in [(0, 2, first), (1, 3, second)] {
                let h = 1.0 / f64::from(edges);
                let is_second_order = of_type >= 2;
                let mut expected = vec![0.0; if is_second_order { 2 * edges as usize + 1 } else { edges as usize + 1 }];
                for edge in 0..edges as usize {
                    let own: &[f64] = if is_second_order { &[1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0] } else { &[0.5, 0.5] };
                    let from = edge * (own.len() - 1);
                    own.iter().enumerate().for_each(|(k, share)| expected[from + k] += share * h);
                }
                let found = shares(&scene, body, 0.5);
                assert_eq!(found.len(), expected.len());
                for ((x, share), expected) in found.iter().zip(&expected) {
                    assert!((share - expected).abs() < 1e-10, "{first} on {second}: {share} for {expected} at {x}");
                }
            }
        }
    }
}

/// A face of eight nodes has −1/12 of its load at a corner and 1/3 in the middle of an edge.
#[test]
fn a_face_of_eight_nodes_pulls_its_corners_back() {
    let below = second_order(&cuboid_hex8([0.0; 3], [1.0, 1.0, 0.5], [1, 1, 1]), 20);
    let above = cuboid_hex8([0.0, 0.0, 0.5], [1.0, 1.0, 1.0], [3, 2, 1]);
    let scene = Scene::of(&[&below, &above]);
    let (contact, start) = (tied(&scene, 0.0), scene.first_node[1]);
    let mut coords = scene.coords.clone();
    coords[start..].iter_mut().for_each(|x| x[1] += 0.002);
    let forces = contact.evaluate(&coords).expect("an evaluation").forces;
    for node in (0..start).filter(|&node| scene.coords[node][2] == 0.5) {
        let is_middle = scene.coords[node][..2].contains(&0.5);
        let expected = if is_middle { 1.0 / 3.0 } else { -1.0 / 12.0 };
        assert!((forces[node][1] / (K * 0.002) - expected).abs() < 1e-10);
    }
}

/// A ring on a ring: what is tied is π (R² − r²), and the force is that of whole rings.
#[test]
fn rings_are_tied_by_their_area() {
    let below = second_order(&rectangle_quad4([1.0, 0.0], [2.0, 0.5], [2, 1]), 9);
    let scene = Scene::of(&[&below, &rectangle_quad4([1.0, 0.5], [2.0, 1.0], [3, 1])]);
    let mut contact = scene.contact(Options { axisymmetric: true, ..Options::new(EnergyLaw::depth(K)) });
    contact.set_pair_options([0, 1].map(Body), Some(PairOptions::tied(0.0))).expect("a tie");
    let area = 0.5 * TAU * (4.0 - 1.0);
    let tie = contact.tie([0, 1]).expect("bodies").expect("a tie");
    assert!((tie.area - area).abs() < 1e-12 * area && tie.largest_gap == 0.0);
    let mut coords = scene.coords.clone();
    coords[scene.first_node[1]..].iter_mut().for_each(|x| x[1] += 0.001);
    let found = contact.evaluate(&coords).expect("an evaluation");
    assert!((found.bodies[0].force[1] - K * 0.001 * area).abs() < 1e-10 * K);
    assert!(
        (found.pairs[0].pressure - K * 0.001).abs() < 1e-10 * K && (found.pairs[0].contact_area - area).abs() < 1e-10
    );
    let nodes = contact.tie_nodes(&coords).expect("nodes");
    assert!(nodes.iter().all(|node| (node.traction[1].abs() - K * 0.001).abs() < 1e-10 * K));
}
