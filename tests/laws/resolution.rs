//! How densely fibers are laid: as asked, as told back, and well enough when nothing is asked.

use crate::pairs::{plane_scene, solid_scene};
use crate::scene::{Scene, distance, exact, fibers, lines, norm};
use fmc_contact::{ContactForces, FiberOptions, FiberPattern, LineWeights, Options, Resolution};

fn counted(pattern: FiberPattern, count: usize) -> Options {
    fibers(FiberOptions { pattern, resolution: Resolution::Count(count), ..FiberOptions::default() })
}

/// Lines cover the box of the region across each family, a line more on every side: in 3D 2·√(n/3) of them on either.
#[test]
fn about_as_many_fibers_as_asked_for() {
    for count in [300, 3_000, 30_000] {
        let lines = [
            plane_scene(1).evaluate(counted(FiberPattern::Lines, count)).fiber_count,
            solid_scene(1).evaluate(counted(FiberPattern::Lines, count)).fiber_count,
        ];
        let rim = |families: f64, axes: f64| 1.0 + 8.0 * axes * (families / count as f64).powf(1.0 / axes);
        assert!(lines[0] as f64 <= rim(2.0, 1.0) * count as f64, "{lines:?} of {count}");
        assert!(lines[1] as f64 <= rim(3.0, 2.0) * count as f64, "{lines:?} of {count}");
        assert!(lines.iter().all(|&n| n as f64 > 0.5 * count as f64), "{lines:?} of {count}");
        let isotropic = FiberPattern::Isotropic { length: None };
        assert_eq!(plane_scene(1).evaluate(counted(isotropic, count)).fiber_count, count);
        assert_eq!(solid_scene(1).evaluate(counted(isotropic, count)).fiber_count, count);
    }
}

/// The spacing of a pair, given back, lays the same lines.
fn spacing_keeps_the_pattern<const D: usize>(scene: &Scene<D>) {
    for resolution in [Resolution::Auto, Resolution::Count(5_000)] {
        let chosen = scene.evaluate(fibers(FiberOptions { resolution, seed: 3, ..FiberOptions::default() }));
        let given: ContactForces<D> = scene.evaluate(lines(chosen.pairs[0].spacing, 3));
        assert_eq!(format!("{given:?}"), format!("{chosen:?}"));
    }
}

#[test]
fn spacing_given_back_keeps_the_pattern() {
    spacing_keeps_the_pattern(&plane_scene(2));
    spacing_keeps_the_pattern(&solid_scene(2));
}

/// While bodies move and deform a little, the automatic lines stay where they are for the most part.
#[test]
fn automatic_pattern_is_steady() {
    let mut spacings = Vec::new();
    for step in 0..50 {
        let s = 0.002 * step as f64;
        let scene = plane_scene(4).mapped(|[x, y]| [x * (1.0 + 0.1 * s), y + 0.2 * s * x]);
        spacings.push(scene.evaluate(fibers(FiberOptions::default())).pairs[0].spacing);
    }
    let changes = spacings.windows(2).filter(|w| w[0] != w[1]).count();
    assert!(changes <= 2, "{spacings:?}");
    // A power of √2: its square is a power of 2, up to the rounding of a root.
    let mantissa = (2.0 * spacings[0].log2()).fract().abs();
    assert!(!(1e-12..=1.0 - 1e-12).contains(&mantissa));
}

/// Without a word from the user, nodal forces are known to a few percent.
fn automatic_forces_are_good<const D: usize>(
    scene: impl Fn(u64) -> Scene<D>,
    weights: LineWeights,
    seeds: u64,
    most: f64,
) {
    let mut squares = 0.0;
    for seed in 0..seeds {
        let scene = scene(seed);
        let reference = scene.evaluate(exact());
        let found = scene.evaluate(fibers(FiberOptions { weights, seed, ..FiberOptions::default() }));
        squares += (distance(&found.forces, &reference.forces) / norm(&reference.forces)).powi(2) / seeds as f64;
    }
    println!("automatic lines in {D}D, {weights:?}: rms force error {:.2e}", squares.sqrt());
    assert!(squares.sqrt() < most, "{}", squares.sqrt());
}

#[test]
fn automatic_lines_give_forces_to_a_few_percent() {
    for weights in [LineWeights::Balance, LineWeights::Consistent] {
        automatic_forces_are_good(plane_scene, weights, 30, 0.02);
        automatic_forces_are_good(solid_scene, weights, 15, 0.04);
    }
}
