//! Friction between cells of second order.

use crate::scene::table::exactly;
use crate::{pair, rectangles};
use fmc_contact::{EnergyLaw, Options, contact::Friction};

/// A block that slides: T = μ N, whatever the cells, and the work of a closed path is that of friction.
#[test]
fn a_block_slides() {
    let delta = 1e-3;
    for lower in rectangles([-1.0, -1.0], [2.0, 0.0], [3, 1]) {
        for upper in rectangles([0.0, -delta], [1.0, 1.0], [2, 2]) {
            for law in [EnergyLaw::depth(10.0), EnergyLaw::fiber(10.0)] {
                let scene = pair(&lower, &upper);
                let friction = Friction { stiffness: Some(1e4), ..Friction::coulomb(0.3) };
                let mut contact = scene.contact(Options { friction, ..exactly(law) });
                contact.begin_step(&scene.coords).expect("a step");
                let mut coords = scene.coords.clone();
                scene.nodes_of(1).for_each(|node| coords[node][0] += 0.01);
                let at = contact.evaluate(&coords).expect("forces");
                let [tangential, normal] = at.bodies[1].force;
                assert!((tangential + 0.3 * normal).abs() < 1e-9 * normal, "{tangential} of {normal}");
                let power: f64 = scene.nodes_of(1).map(|node| at.forces[node][0]).sum();
                assert!((power - tangential).abs() < 1e-12 * normal);
                contact.commit_step(&coords).expect("a step");
            }
        }
    }
}
