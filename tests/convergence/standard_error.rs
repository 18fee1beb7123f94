//! The reported standard error of the volume against the spread over seeds.

use crate::scene::{Scene, exact, isotropic, lines};
use crate::star::star_and_block;
use fmc_contact::{ContactForces, Options};
use fmc_shapes::{icosphere, random_rotation};

/// Mean over the seeds of the squared error and of the squared standard error, both relative to V².
fn variances<const D: usize>(scene: &Scene<D>, options: impl Fn(u64) -> Options, seeds: u64) -> [f64; 2] {
    let mut contact = scene.contact(exact());
    let volume = contact.evaluate(&scene.coords).unwrap().volume;
    let (mut actual, mut reported) = (0.0, 0.0);
    for seed in 0..seeds {
        contact.set_options(options(seed)).unwrap();
        let found: ContactForces<D> = contact.evaluate(&scene.coords).unwrap();
        actual += (found.volume / volume - 1.0).powi(2) / seeds as f64;
        reported += (found.standard_error / volume).powi(2) / seeds as f64;
    }
    [actual, reported]
}

/// Both means scatter by about (2/n)^½ of themselves for n normal numbers, 10 % for 200; by 1.5 no honest pair differs.
fn honest([actual, reported]: [f64; 2]) {
    println!("rms error {:.2e}, rms standard error {:.2e}", actual.sqrt(), reported.sqrt());
    assert!(reported < 1.5 * actual && actual < 1.5 * reported, "{actual:e} against {reported:e}");
}

/// The spread of two families is one number; its mean over seeds is the variance all the same.
#[test]
fn standard_error_of_lines_is_the_spread_over_seeds() {
    let scene = star_and_block();
    for spacing in [0.03, 0.006] {
        honest(variances(&scene, |seed| lines(spacing, seed), 400));
    }
    let a = icosphere(1.0, 2).rotated_by(random_rotation(1));
    let b = icosphere(1.0, 2).rotated_by(random_rotation(2)).translated([1.6, 0.2, 0.3]);
    let scene = Scene::of(&[&a, &b]);
    for spacing in [0.2, 0.07] {
        honest(variances(&scene, |seed| lines(spacing, seed), 400));
    }
}

#[test]
fn standard_error_of_isotropic_fibers_is_the_spread_over_seeds() {
    honest(variances(&star_and_block(), |seed| isotropic(0.1, 500, seed), 400));
}
