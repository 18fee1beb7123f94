//! Friction on curved and smoothed faces: forces follow motions without a jump.

use crate::curves::sector;
use crate::depth;
use crate::scene::Scene;
use fmc_contact::Options;
use fmc_contact::contact::Friction;
use fmc_shapes::{Mesh, Splitmix, cuboid_hex8, rectangle_quad4, second_order};
use std::f64::consts::TAU;

const STEPS: usize = 100;

/// A point of a facet is the middle of what it has in a cell, or in the layer beside it: another place, such as that of the largest part, would
/// jump as parts come and go. Along a straight way that is so short that no facet leaves a cell, all changes are about the same.
fn follows<const D: usize>(scene: &Scene<D>, smoothing: Option<f64>) {
    let mut contact = scene.contact(Options { friction: Friction::coulomb(0.3), ..depth(1.0) });
    if let Some(angle) = smoothing {
        contact.set_surface_smoothing(angle).expect("an angle");
    }
    contact.begin_step(&scene.coords).expect("a step");
    let mut random = Splitmix::new(11);
    let way: Vec<[f64; D]> = scene.coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
    let at = |part: f64| -> Vec<[f64; D]> {
        let along = |x: &[f64; D], way: &[f64; D]| {
            // Slip by more than the elastic one, and a little disorder.
            std::array::from_fn(|k| x[k] + if k == 0 { 1e-4 } else { 0.0 } + 1e-6 * (1.0 + part) * way[k])
        };
        scene.coords.iter().zip(&way).map(|(x, way)| along(x, way)).collect()
    };
    let forces = |part: f64| contact.evaluate(&at(part)).expect("valid coordinates").forces;
    let mut last = forces(0.0);
    let mut changes: Vec<f64> = (1..=STEPS)
        .map(|k| {
            let now = forces(k as f64 / STEPS as f64);
            let change = now.iter().zip(&last).flat_map(|(a, b)| (0..D).map(move |k| (a[k] - b[k]).abs()));
            let change = change.fold(0.0, f64::max);
            last = now;
            change
        })
        .collect();
    changes.sort_by(f64::total_cmp);
    let [median, most] = [changes[STEPS / 2], changes[STEPS - 1]];
    // Where a facet begins to slide forces change at another rate, by less than twice that.
    assert!(median > 0.0 && most < 3.0 * median, "{most:e}, in the middle {median:e}");
}

#[test]
fn in_space() {
    let low = |from: f64| [0.0, from, 0.0];
    let rings = |overlap: f64, [n, m]: [usize; 2], height: f64| {
        [
            sector(cuboid_hex8(low(0.5), [1.0, 1.0 + overlap, 0.5], [n, 1, 1]), 0.25 * TAU),
            sector(cuboid_hex8(low(1.0), [1.0, 1.5, height], [m, 1, 2]), 0.25 * TAU),
        ]
    };
    for (overlap, cells, height) in [(0.0, [6, 9], 0.3), (1e-3, [4, 6], 0.5), (1e-2, [7, 6], 0.3)] {
        let [inner, outer] = rings(overlap, cells, height);
        follows(&Scene::of(&[&inner, &outer]), Some(30.0));
    }
    let curved = |mesh: Mesh<3>| sector(second_order(&mesh, 27), 0.25 * TAU);
    let inner = curved(cuboid_hex8(low(0.5), [1.0, 1.001, 0.5], [3, 1, 1]));
    let outer = curved(cuboid_hex8(low(1.0), [1.0, 1.5, 0.4], [4, 1, 1]));
    follows(&Scene::of(&[&inner, &outer]), None);
}

#[test]
fn in_the_plane() {
    let ring = |from: f64, to: f64, count| sector(rectangle_quad4([0.0, from], [1.0, to], [count, 2]), 0.25 * TAU);
    for (overlap, [n, m]) in [(0.0, [6, 9]), (1e-3, [4, 6]), (1e-2, [7, 6])] {
        follows(&Scene::of(&[&ring(0.5, 1.0 + overlap, n), &ring(1.0, 1.5, m)]), Some(30.0));
    }
}
