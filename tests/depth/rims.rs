//! Round faces that end at flat ones: a pin in its hole is measured as curved up to the rims.

use crate::curves::sector;
use crate::depth;
use crate::derivatives::{force_is_the_slope_of_the_energy, forces_balance, tangent_is_the_slope_of_the_force};
use crate::scene::Scene;
use fmc_contact::Contact;
use fmc_shapes::{Mesh, Splitmix, cuboid_hex8, cuboid_tet4, second_order};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Facets around: each stands for an arc .048 above it.
const FACETS: usize = 32;

/// A ring between two radii and two heights; its cells outwards are two.
fn ring(nodes: usize, [from, to]: [f64; 2], [low, high]: [f64; 2], layers: usize, turn: f64) -> Mesh<3> {
    let (min, max, cells) = ([0.0, from, low], [1.0, to, high], [FACETS, 2, layers]);
    let straight = if nodes == 4 || nodes == 10 { cuboid_tet4(min, max, cells) } else { cuboid_hex8(min, max, cells) };
    let mut mesh = sector(if nodes == 4 || nodes == 8 { straight } else { second_order(&straight, nodes) }, TAU);
    // The ends of the sector fall together.
    let mut first = BTreeMap::new();
    let key = |x: &[f64; 3]| x.map(|x| (x * 1e9).round() as i64);
    let same: Vec<u32> = (0..).zip(&mesh.coords).map(|(node, x)| *first.entry(key(x)).or_insert(node)).collect();
    mesh.conn.iter_mut().for_each(|node| *node = same[*node as usize]);
    for x in &mut mesh.coords {
        (x[0], x[1]) = (x[0] * turn.cos() - x[1] * turn.sin(), x[0] * turn.sin() + x[1] * turn.cos());
    }
    mesh
}

/// Heights between which a pin reaches, its cells along them, and those of the lug, which reaches from 0 to 5.
type Along = ([f64; 2], usize, usize);

/// Rims at one height, of a pin that goes through, and of one that ends in the hole.
const RIMS: [Along; 4] = [([0.0, 5.0], 1, 1), ([0.0, 5.0], 2, 3), ([-5.0, 10.0], 3, 1), ([1.0, 4.0], 1, 2)];

/// A pin of radius 10 in a hole, turned by 0.4 facets.
fn pin_in_lug(nodes: usize, hole: f64, (heights, of_pin, of_lug): Along) -> Scene<3> {
    let turn = 0.4 * TAU / FACETS as f64;
    Scene::of(&[&ring(nodes, [5.0, 10.0], heights, of_pin, turn), &ring(nodes, [hole, 20.0], [0.0, 5.0], of_lug, 0.0)])
}

fn contact(scene: &Scene<3>, stiffness: f64) -> Contact<3> {
    let mut contact = scene.contact(depth(stiffness));
    contact.set_surface_smoothing(30.0).expect("an angle");
    contact
}

/// The force that presses the pin inwards.
fn pressed(scene: &Scene<3>, forces: &[[f64; 3]]) -> f64 {
    let inwards = |node: usize| {
        let (x, f) = (scene.coords[node], forces[node]);
        -(f[0] * x[0] + f[1] * x[1]) / x[0].hypot(x[1])
    };
    scene.nodes_of(0).map(inwards).sum()
}

/// Through an open clearance nothing presses along the rims, though the straight facets of both overlap by up to .038: parts of the energy that
/// a sag without the other would have on all of the contact. Ends of both in one plane touch by rounding.
#[test]
fn nothing_presses_through_a_clearance() {
    for nodes in [8, 20, 4] {
        for along in [RIMS[0], RIMS[1], RIMS[3]] {
            let scene = pin_in_lug(nodes, 10.01, along);
            let of_sag = 0.5 * 0.048_f64.powi(2) * 10.0 * TAU * (along.0[1] - along.0[0]);
            let found = contact(&scene, 1.0).evaluate(&scene.coords).expect("valid coordinates");
            assert!(found.energy < 2e-5 * of_sag, "{nodes}, {along:?}: {}", found.energy);
        }
    }
}

/// An interference of .003 presses by k δ on the area of the shorter one. Beside free ends the depth of the straight cells is less than the
/// distance from the bore, and a longer pin is pressed by the straight edges of flat ends, too. Faces of second order are their circles to a fraction of
/// the interference; of first order the circles through smoothed facets are not.
#[test]
fn rims_press_as_what_lies_between_them() {
    let delta = 3e-3;
    for (nodes, within) in [(8, 0.05), (20, 0.015), (4, 0.12)] {
        for along in RIMS {
            let scene = pin_in_lug(nodes, 10.0 - delta, along);
            let found = contact(&scene, 1.0).evaluate(&scene.coords).expect("valid coordinates");
            let height = (along.0[1] - along.0[0]).min(5.0);
            let area = 10.0 * TAU * height;
            let force = pressed(&scene, &found.forces) / (delta * area);
            assert!((force - 1.0).abs() < within, "{nodes}, {along:?}: {force}");
        }
    }
}

/// As the rim of a pin passes the rim of a hole, the work along the way is the energy, in steps of .01 by trapezoids. The depths of two faces that
/// meet at a rim are one inside the body, and nearly so outside.
#[test]
fn rims_pass_without_a_jump() {
    let scene = pin_in_lug(8, 9.99, ([-3.0, 2.0], 1, 1));
    let contact = contact(&scene, 1.0);
    let (step, mut before) = (0.01, None::<(f64, f64)>);
    for k in 0..=40 {
        let mut coords = scene.coords.clone();
        scene.nodes_of(1).for_each(|node| coords[node][2] += -3.2 + step * f64::from(k));
        let found = contact.evaluate(&coords).expect("valid coordinates");
        let force: f64 = scene.nodes_of(1).map(|node| found.forces[node][2]).sum();
        if let Some((energy, old)) = before {
            let left = found.energy - energy + 0.5 * (force + old) * step;
            assert!(left.abs() < 1e-3 * found.energy, "step {k}: {left:e} of {:e}", found.energy);
        }
        before = Some((found.energy, force));
    }
}

/// Between the layers of neighbours along a rim feet differ a little, by some 1e-5 of the force. The longer pin has no nodes at the height of a rim:
/// there the energy has a bend.
#[test]
fn derivatives_at_rims() {
    for (nodes, along) in [(8, RIMS[0]), (8, ([-4.0, 9.0], 3, 1)), (20, RIMS[3]), (4, RIMS[0])] {
        for delta in [3e-3, 0.05] {
            let scene = pin_in_lug(nodes, 10.0 - delta, along);
            let contact = contact(&scene, 30.0);
            let mut random = Splitmix::new(5);
            let coords: Vec<[f64; 3]> =
                scene.coords.iter().map(|x| x.map(|x| x + random.between(-1e-3, 1e-3))).collect();
            forces_balance(&contact, &coords);
            force_is_the_slope_of_the_energy(&contact, &coords, 5e-5);
            tangent_is_the_slope_of_the_force(&contact, &coords, 1e-2);
        }
    }
}
