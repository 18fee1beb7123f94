//! What a result says of a contact means the same under every law and estimator, and has the values of closed forms.

use crate::scene::table::exactly;
use crate::scene::{Scene, by_lines, exact, fibers};
use fmc_contact::contact::{StiffnessFrom, suggest_fiber_stiffness, suggest_stiffness};
use fmc_contact::{EnergyLaw, FiberOptions, Options};
use fmc_shapes::{cuboid_hex8, rectangle_quad4};

const K: f64 = 1e4;

/// Every law with every estimator that measures it; sampled lines know sizes to a percent.
fn methods() -> [(&'static str, Options, f64); 5] {
    let volume = EnergyLaw::volume(K);
    [
        ("volume, exact", Options { law: volume, ..exact() }, 1e-12),
        ("volume, fibers", Options { law: volume, ..fibers(FiberOptions::default()) }, 0.01),
        ("fiber, exact", exactly(EnergyLaw::fiber(K)), 1e-12),
        ("fiber, fibers", by_lines(EnergyLaw::fiber(K)), 0.01),
        ("depth", Options::new(EnergyLaw::depth(K)), 1e-12),
    ]
}

fn check(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found / expected - 1.0).abs() <= tolerance, "{what}: {found} for {expected}");
}

/// A block of width 0.7 (3D: 0.7 x 0.6), 0.01 deep in a wider one. The overlap is 0.01 times its face; its boundary is that
/// face twice, and the strips of both side walls, which lines along the normal do not cross.
#[test]
fn of_two_blocks_with_flat_faces() {
    let plane = Scene::of(&[
        &rectangle_quad4([0.0; 2], [1.0; 2], [10, 10]),
        &rectangle_quad4([0.2, 0.99], [0.9, 1.99], [7, 10]),
    ]);
    let solid = Scene::of(&[
        &cuboid_hex8([0.0; 3], [1.0; 3], [5; 3]),
        &cuboid_hex8([0.2, 0.1, 0.99], [0.9, 0.7, 1.99], [7, 6, 5]),
    ]);
    for (name, options, tolerance) in methods() {
        for (found, face, walls) in [
            (plane.evaluate(options).pairs.remove(0), 0.7, 0.01 * 2.0),
            (solid.evaluate(options).pairs.remove(0), 0.42, 0.01 * 2.6),
        ] {
            check(found.volume, 0.01 * face, tolerance, &format!("{name}, volume"));
            // The mean normal of sampled crossings leans, and the extent along it is that of a long strip.
            let leaning = if name == "volume, fibers" { 0.1 } else { tolerance };
            check(found.penetration, 0.01, leaning, &format!("{name}, penetration"));
            let strips = if options.law.is_fiber() { 0.0 } else { 0.5 * walls };
            check(found.contact_area, face + strips, tolerance, &format!("{name}, area"));
            let mean = match options.law {
                EnergyLaw::Volume { .. } => K,
                _ => K * 0.01,
            };
            // Strips, and the rim of coarse cells, are less deep, and are part of the mean of the law `depth`.
            let shallow = if name == "depth" { 0.1 } else { tolerance };
            check(found.pressure, mean, shallow, &format!("{name}, pressure"));
        }
    }
}

/// Two unit squares that overlap in a rectangle of 0.4 x 0.5, at a corner of each: lines run both ways.
#[test]
fn of_two_corners() {
    let scene = Scene::of(&[
        &rectangle_quad4([0.0; 2], [1.0; 2], [10, 10]),
        &rectangle_quad4([0.6, 0.5], [1.6, 1.5], [10, 10]),
    ]);
    for (name, options, tolerance) in methods() {
        let found = scene.evaluate(options).pairs.remove(0);
        check(found.volume, 0.2, tolerance, &format!("{name}, volume"));
        check(found.contact_area, 0.9, tolerance, &format!("{name}, area"));
        // The longest line; the deepest place; the extent along the mean normal, which is (0.5, 0.4).
        let penetration = match options.law {
            EnergyLaw::Fiber(_) => 0.5,
            EnergyLaw::Depth { .. } => 0.4,
            _ => 0.4 / 0.41f64.sqrt(),
        };
        check(found.penetration, penetration, tolerance, &format!("{name}, penetration"));
        let total = scene.evaluate(options);
        assert_eq!((total.volume, total.contact_area), (found.volume, found.contact_area), "{name}");
    }
}

/// Teeth with gaps between them, nine tenths of each in contact: what gapes is no contact.
#[test]
fn of_facets_that_gape() {
    let upper = rectangle_quad4([0.0, 0.0], [1.0, 1.0], [8, 4]).mapped(|[x, y]| {
        let is_low = (8.0 * x).round() as i32 % 2 == 1;
        [
            x,
            if y > 0.0 {
                y
            } else if is_low {
                -9e-4
            } else {
                1e-4
            },
        ]
    });
    let scene = Scene::of(&[&upper, &rectangle_quad4([-0.5, -1.0], [1.5, 0.0], [6, 3])]);
    for (name, options, tolerance) in methods() {
        let found = scene.evaluate(options).pairs.remove(0);
        // The slopes of the teeth are longer than the ground below them by 3e-5.
        check(found.contact_area, 0.9, tolerance.max(1e-4), &format!("{name}, area"));
        check(found.volume, 0.9 * 4.5e-4, tolerance, &format!("{name}, volume"));
    }
}

/// The pressure that was asked for comes at the penetration that was accepted; the law `volume` has a fifth to spare.
#[test]
fn suggested_stiffness_gives_the_pressure() {
    let peak = StiffnessFrom::PeakPressure { pressure: 3e6, overlap: 2e-4 };
    let fiber = EnergyLaw::fiber(suggest_fiber_stiffness(peak).expect("a stiffness"));
    check(fiber.energy_gradient(2e-4), 3e6, 1e-14, "fiber");
    for m in [1.0, 1.5, 2.0] {
        let stiffness = suggest_stiffness(peak, 2, m).expect("a stiffness");
        check(EnergyLaw::Volume { stiffness, exponent: m }.energy_gradient(2e-4), 3.6e6, 1e-14, "volume");
    }
    let modulus = StiffnessFrom::Modulus { modulus: 2e11, facet_size: 0.03 };
    let fiber = EnergyLaw::fiber(suggest_fiber_stiffness(modulus).expect("a stiffness"));
    check(fiber.energy_gradient(0.003), 2e11, 1e-14, "fiber from a modulus");
}
