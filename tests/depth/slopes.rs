//! Signed distances that are none: too steep ones are refused whatever the law, gentle ones are told. And obstacles inside bodies.

use crate::depth;
use crate::scene::Scene;
use crate::scene::table::table;
use fmc_contact::{Contact, Error, Obstacle, Options, Pose, Shape, Warning};
use fmc_shapes::{Diagonals, cuboid_hex8, rectangle_tri3};
use std::sync::Arc;

type Distance = fn(&[f64; 2]) -> (f64, [f64; 2]);

fn plane(x: &[f64; 2]) -> (f64, [f64; 2]) {
    (0.6 * x[0] + 0.8 * x[1] - 0.2, [0.6, 0.8])
}

fn ball(x: &[f64; 2]) -> (f64, [f64; 2]) {
    let r = (x[0] - 0.5).hypot(x[1] + 0.4);
    (r - 0.5, [(x[0] - 0.5) / r, (x[1] + 0.4) / r])
}

/// (x/a)² + (y/b)² − 1, as it stands in books.
fn ellipse(x: &[f64; 2]) -> (f64, [f64; 2]) {
    let y = [x[0] - 0.5, (x[1] + 0.4) / 0.5];
    (y[0] * y[0] + y[1] * y[1] - 1.0, [2.0 * y[0], 4.0 * y[1]])
}

fn against(distance: Distance, slope: f64, options: Options, size: f64) -> (Contact<2>, Scene<2>) {
    let mesh = rectangle_tri3([0.0; 2], [size, size], [4, 3], Diagonals::Alternating);
    let scene = Scene::of(&[&mesh]);
    let mut contact = scene.contact(options);
    let scaled = move |x: &[f64; 2]| {
        let (phi, gradient) = distance(&[x[0] / size, x[1] / size]);
        (slope * size * phi, gradient.map(|g| slope * g))
    };
    let shape = Shape::SignedDistance(Arc::new(scaled));
    contact.add_obstacle(Obstacle { shape, pose: Pose::at([0.0; 2]) }).expect("an obstacle");
    (contact, scene)
}

#[test]
fn steep_ones_are_refused_by_all_laws() {
    for options in table(1.0) {
        for size in [1e-3, 1.0, 1e4] {
            for (distance, slope) in
                [(plane as Distance, 1.02), (plane, 2.0), (ball, 1.5), (ball, 30.0), (ellipse, 1.0)]
            {
                let (contact, scene) = against(distance, slope, options, size);
                let found = contact.evaluate(&scene.coords);
                let (places, phi) = match found {
                    Err(Error::SteepDistance { obstacle: 0, places, phi }) => (places, phi),
                    // Laws and estimators that have no signed distances at all.
                    Err(Error::Unsupported { .. }) => continue,
                    other => panic!("{slope}, {options:?}: {other:?}"),
                };
                let [p, q] = places;
                let apart = (p[0] - q[0]).hypot(p[1] - q[1]);
                assert!((phi[0] - phi[1]).abs() > apart, "{phi:?} at {p:?} and {q:?}");
            }
            for distance in [plane, ball] {
                let (contact, scene) = against(distance, 1.0, options, size);
                let found = match contact.evaluate(&scene.coords) {
                    Err(Error::Unsupported { .. }) => continue,
                    found => found.expect("a distance"),
                };
                assert!(!found.warnings.iter().any(|w| matches!(w, Warning::GentleDistance { .. })), "{found:?}");
            }
        }
    }
}

/// The pressures of the law `depth` are too small by the slope, which is told.
#[test]
fn gentle_ones_are_told() {
    for slope in [0.01, 0.3, 0.6, 0.9, 0.98] {
        for distance in [plane, ball] {
            let (contact, scene) = against(distance, slope, depth(1.0), 1.0);
            let found = contact.evaluate(&scene.coords).expect("a function that grows slowly");
            let told = found.warnings.iter().find_map(|w| match w {
                Warning::GentleDistance { slopes, .. } => Some(*slopes),
                _ => None,
            });
            let told = told.expect("a warning");
            // Over the way at which it is taken a ball is curved.
            assert!(told.iter().all(|told| (told / slope - 1.0).abs() < 1e-2), "{told:?}, not {slope}");
        }
    }
}

/// Without a facet of the body in it nothing pushes an obstacle out, nor where it touches one from inside.
#[test]
fn obstacles_inside_bodies_are_told() {
    let scene = Scene::of(&[&cuboid_hex8([-1.0; 3], [1.0; 3], [4; 3])]);
    for shape in [
        Shape::Ball { radius: 0.2 },
        Shape::Cuboid { half_extents: [0.2, 0.3, 0.2] },
        Shape::Capsule { radius: 0.1, half_height: 0.2 },
    ] {
        for (x, is_inside) in [(0.1, true), (0.95, false), (2.0, false)] {
            let mut contact = scene.contact(depth(1.0));
            contact
                .add_obstacle(Obstacle { shape: shape.clone(), pose: Pose::at([x, 0.13, 0.05]) })
                .expect("an obstacle");
            let found = contact.evaluate(&scene.coords).expect("valid coordinates");
            let is_told = found.warnings.iter().any(|w| matches!(w, Warning::SwallowedBody { .. }));
            assert_eq!(is_told, is_inside, "{shape:?} at {x}: {:?}", found.warnings);
        }
    }
    let mut contact = scene.contact(depth(1.0));
    let touching =
        Obstacle { shape: Shape::Capsule { radius: 0.1, half_height: 0.2 }, pose: Pose::at([0.9, 0.13, 0.05]) };
    contact.add_obstacle(touching).expect("an obstacle");
    let found = contact.evaluate(&scene.coords).expect("valid coordinates");
    assert!(found.warnings.iter().any(|w| matches!(w, Warning::SwallowedBody { .. })), "{:?}", found.warnings);
}
