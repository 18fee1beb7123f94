//! The tangent against differences. What it leaves out is of the size of the penetration by that of the facets.

use crate::scene::Scene;
use crate::{begun, in_plane, in_space, laws, raised, slid};
use fmc_contact::Options;
use fmc_contact::contact::{Friction, TangentPart};
use fmc_shapes::Splitmix;

/// Largest difference of the friction's part of the tangent from that of its forces, by its largest product; the upper
/// block stood `above` when the step began.
fn error<const D: usize>(scene: &Scene<D>, options: Options, way: (f64, f64), delta: f64) -> f64 {
    error_with(scene, options, way, delta, false)
}

/// The same, also of surfaces that multipliers move out.
fn error_with<const D: usize>(
    scene: &Scene<D>,
    options: Options,
    (by, above): (f64, f64),
    delta: f64,
    is_moved_out: bool,
) -> f64 {
    let mut contact = begun(scene, options, &raised(scene, above));
    let mut smooth = scene.contact(Options { friction: Friction::default(), ..options });
    let mut random = Splitmix::new(5);
    let mut coords = slid(scene, by);
    coords.iter_mut().flatten().for_each(|x| *x += 0.05 * delta * random.between(-1.0, 1.0));
    if is_moved_out {
        contact.augment(&coords, 0.1, 0.0).expect("multipliers");
        smooth.set_multipliers(&contact.multipliers()).expect("multipliers");
    }
    let tangent = contact.tangent(&coords, TangentPart::Full).expect("a tangent");
    let without = smooth.tangent(&coords, TangentPart::Full).expect("a tangent");
    let mut largest = (0.0f64, 0.0f64);
    for _ in 0..4 {
        let direction: Vec<[f64; D]> =
            coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        let friction_at = |h: f64| {
            let at: Vec<[f64; D]> =
                coords.iter().zip(&direction).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect();
            let (with, without) = (contact.evaluate(&at).expect("forces"), smooth.evaluate(&at).expect("forces"));
            let pairs = with.forces.into_iter().flatten().zip(without.forces.into_iter().flatten());
            pairs.map(|(f, g)| f - g).collect::<Vec<f64>>()
        };
        let step = 1e-5 * delta;
        let (plus, minus) = (friction_at(step), friction_at(-step));
        let (with, without) = (tangent.product(&direction), without.product(&direction));
        let products = with.iter().flatten().zip(without.iter().flatten()).map(|(p, q)| p - q);
        for (product, (p, m)) in products.zip(plus.iter().zip(&minus)) {
            let slope = (m - p) / (2.0 * step);
            largest = (largest.0.max((slope - product).abs()), largest.1.max(product.abs()));
        }
    }
    largest.0 / largest.1
}

#[test]
fn of_the_friction_part() {
    // Facets of about 0.3.
    for delta in [1e-2, 1e-3] {
        let most = 0.5 * delta / 0.3 * 4.0;
        for by in [0.1 * delta, delta] {
            for options in laws(0.3) {
                for scene in in_plane(delta) {
                    let found = error(&scene, options, (by, 0.0), delta);
                    println!("2D {:?} by {by}: {found:.2e} of {most:.2e}", options.law);
                    assert!(found < most, "{:?} by {by}: {found} of {most}", options.law);
                }
                for scene in in_space(delta) {
                    let found = error(&scene, options, (by, 0.0), delta);
                    println!("3D {:?} by {by}: {found:.2e} of {most:.2e}", options.law);
                    assert!(found < most, "{:?} by {by}: {found} of {most}", options.law);
                }
            }
        }
    }
}

/// Of a block that touches when a third of the step is over: the nearer it comes, the more of its slip counts.
#[test]
fn of_what_touches_within_the_step() {
    let delta = 1e-3;
    let most = 0.5 * delta / 0.3 * 4.0;
    for (by, options) in [0.2 * delta, 2.0 * delta].into_iter().flat_map(|by| laws(0.3).map(|options| (by, options))) {
        for scene in in_plane(delta) {
            let found = error(&scene, options, (by, 1.5 * delta), delta);
            assert!(found < most, "2D {:?} by {by}: {found} of {most}", options.law);
        }
        for scene in in_space(delta) {
            let found = error(&scene, options, (by, 1.5 * delta), delta);
            assert!(found < most, "3D {:?} by {by}: {found} of {most}", options.law);
        }
    }
}

/// Of surfaces that multipliers move out, where they press with twice their penetration; in the step in which they are moved out.
#[test]
fn of_surfaces_that_are_moved_out() {
    let delta = 1e-3;
    let most = 2.0 * 0.5 * delta / 0.3 * 4.0;
    for (by, above) in [(0.1, 0.0), (1.0, 0.0), (0.2, 1.5), (2.0, 1.5)] {
        for options in laws(0.3) {
            let way = (by * delta, above * delta);
            let planes = in_plane(delta).map(|scene| error_with(&scene, options, way, delta, true));
            let spaces = in_space(delta).map(|scene| error_with(&scene, options, way, delta, true));
            println!("{:?} {way:?}: {planes:?} {spaces:?} of {most:.2e}", options.law);
            assert!(planes.iter().chain(&spaces).all(|found| *found < most), "{options:?}: {planes:?} {spaces:?}");
        }
    }
}
