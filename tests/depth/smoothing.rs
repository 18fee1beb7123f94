//! Where straight faces are one smooth surface.

use crate::curves::sector;
use crate::depth;
use crate::scene::Scene;
use fmc_shapes::{Mesh, cuboid_hex8, rectangle_quad4};
use std::f64::consts::{FRAC_PI_4, TAU};

/// The face of a cube from radius `from` to `to`, as a part of a ball, `count` cells wide: an edge of it is 90° by `count`, or nearly so.
fn cap(from: f64, to: f64, count: usize) -> Mesh<3> {
    let mut mesh = cuboid_hex8([-1.0, -1.0, from], [1.0, 1.0, to], [count, count, 1]);
    for x in &mut mesh.coords {
        let way = [(x[0] * FRAC_PI_4).tan(), (x[1] * FRAC_PI_4).tan(), 1.0];
        let length = way.iter().map(|w| w * w).sum::<f64>().sqrt();
        *x = way.map(|w| x[2] * w / length);
    }
    mesh
}

/// Energies of two bodies by the feature angle.
fn energies<const D: usize>(bodies: [&Mesh<D>; 2], angles: &[f64]) -> Vec<f64> {
    let scene = Scene::of(&bodies);
    let energy = |angle: &f64| {
        let mut contact = scene.contact(depth(1.0));
        contact.set_surface_smoothing(*angle).expect("an angle");
        contact.evaluate(&scene.coords).expect("valid coordinates").energy
    };
    angles.iter().map(energy).collect()
}

/// A ball of 16 facets around turns by 24.5° from a facet to the next, and by up to 31° around a vertex: what counts is the angle at edges.
#[test]
fn a_feature_is_an_edge() {
    let [ball, socket] = [cap(0.5, 1.001, 4), cap(1.0, 1.5, 5)];
    let found = energies([&ball, &socket], &[25.0, 28.0, 31.0, 35.0, 60.0]);
    assert!(found[0] > 0.0 && found.iter().all(|energy| *energy == found[0]), "{found:?}");
    // At smaller angles most edges are features.
    assert!(energies([&ball, &socket], &[15.0])[0] != found[0]);
}

/// Coordinates from a file have seven digits, so faces in a plane of symmetry tilt against each other: the surface goes on behind them as behind
/// a plane.
#[test]
fn planes_with_rounding() {
    let digits = |mesh: &Mesh<3>| {
        let mut mesh = mesh.clone();
        mesh.coords.iter_mut().for_each(|x| *x = x.map(|x| (x * 1e7).round() * 1e-7));
        mesh
    };
    let ring =
        |from: f64, to: f64, count| sector(cuboid_hex8([0.0, from, 0.0], [1.0, to, 0.5], [count, 2, 3]), 0.25 * TAU);
    let [inner, outer] = [ring(0.5, 1.001, 5), ring(1.0, 1.5, 6)];
    let energy = |bodies: [&Mesh<3>; 2]| {
        let scene = Scene::of(&bodies);
        let mut contact = scene.contact(depth(1.0));
        let plane = |axis: usize, at: f64| [[at; 3], std::array::from_fn(|k| f64::from(u8::from(k == axis)))];
        contact.set_symmetry_planes(&[plane(0, 0.0), plane(1, 0.0), plane(2, 0.0), plane(2, 0.5)]).expect("planes");
        contact.set_surface_smoothing(30.0).expect("an angle");
        contact.evaluate(&scene.coords).expect("valid coordinates").energy
    };
    let [exact, rounded] = [energy([&inner, &outer]), energy([&digits(&inner), &digits(&outer)])];
    // A penetration of 1e-3 changes by 1e-7.
    assert!((rounded / exact - 1.0).abs() < 3e-4, "{rounded} {exact}");
}

/// In the plane facets that meet at less than the feature angle are one smooth line.
#[test]
fn in_the_plane() {
    let ring = |from: f64, to: f64, count| sector(rectangle_quad4([0.0, from], [1.0, to], [count, 2]), 0.25 * TAU);
    let found = energies([&ring(0.5, 1.001, 5), &ring(1.0, 1.5, 6)], &[16.0, 19.0, 60.0]);
    // 18° and 15° from facet to facet.
    assert!(found[1] == found[2] && found[0] != found[1], "{found:?}");
}
