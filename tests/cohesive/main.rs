//! Cohesive interfaces: they open, slide and break by a closed form, keep what they have been through, and have one energy.

#[path = "../scene/scene.rs"]
mod scene;
#[path = "../scene/thin.rs"]
mod thin_bodies;

mod changed;
mod curve;
mod derivatives;
mod friction;
mod history;
mod messages;
mod ppr;
mod thin;
mod viscosity;

use fmc_contact::contact::{Cohesive, PairOptions};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::{cuboid_hex8, cuboid_tet4, rectangle_quad4, second_order};
use scene::Scene;

/// Strengths and energies that differ, so that the mode matters; damage begins at an opening of 1e-3 and ends at one of 0.1.
fn law() -> Cohesive {
    Cohesive { shear_strength: 3.0, shear_energy: 0.4, ..Cohesive::new(2.0, 0.1) }
}

fn held<const D: usize>(scene: &Scene<D>, cohesive: Cohesive) -> Contact<D> {
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(1.0)));
    let options = PairOptions::with_cohesive(cohesive);
    contact.set_pair_options([Body(0), Body(1)], Some(options)).expect("an interface");
    contact
}

/// Two blocks of width 1 and height 1/2, one above the other, with meshes that do not match, of first and of second order.
fn in_the_plane(gap: f64) -> Vec<Scene<2>> {
    let below = rectangle_quad4([0.0, 0.0], [1.0, 0.5], [2, 1]);
    let above = rectangle_quad4([0.0, 0.5 + gap], [1.0, 1.0 + gap], [3, 1]);
    vec![Scene::of(&[&below, &above]), Scene::of(&[&second_order(&below, 9), &second_order(&above, 8)])]
}

fn in_space(gap: f64) -> Vec<Scene<3>> {
    let below = cuboid_hex8([0.0; 3], [1.0, 1.0, 0.5], [2, 1, 1]);
    let (from, to) = ([0.0, 0.0, 0.5 + gap], [1.0, 1.0, 1.0 + gap]);
    let above = cuboid_hex8(from, to, [1, 2, 1]);
    let tets = cuboid_tet4(from, to, [1, 1, 1]);
    vec![
        Scene::of(&[&below, &above]),
        Scene::of(&[&second_order(&below, 27), &above]),
        Scene::of(&[&below, &second_order(&tets, 10)]),
    ]
}

/// The nodes of the second body moved.
fn moved<const D: usize>(scene: &Scene<D>, by: [f64; D]) -> Vec<[f64; D]> {
    let start = scene.first_node[1];
    let moved = |(node, x): (usize, &[f64; D])| std::array::from_fn(|i| x[i] + if node >= start { by[i] } else { 0.0 });
    scene.coords.iter().enumerate().map(moved).collect()
}

fn largest<const D: usize>(rows: &[[f64; D]]) -> f64 {
    rows.iter().flatten().fold(0.0, |most, x| most.max(x.abs()))
}
