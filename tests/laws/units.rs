//! The unit of length does not matter: with one that is a power of 2, not a bit changes.

use crate::pairs::{plane_scene, solid_scene};
use crate::scene::{Scene, exact, fibers};
use fmc_contact::{FiberOptions, FiberPattern, LineWeights, Options};

fn estimators() -> Vec<Options> {
    let consistent = FiberOptions { weights: LineWeights::Consistent, balance: false, ..FiberOptions::default() };
    let isotropic = FiberOptions { pattern: FiberPattern::Isotropic { length: None }, ..FiberOptions::default() };
    vec![exact(), fibers(FiberOptions::default()), fibers(consistent), fibers(isotropic)]
}

fn unit_does_not_matter<const D: usize>(scene: &Scene<D>) {
    for power in [-20, -2, 4, 30] {
        let unit = 2f64.powi(power);
        let scaled = scene.clone().mapped(|x| x.map(|x| x * unit));
        for options in estimators() {
            let (found, expected) = (scaled.evaluate(options), scene.evaluate(options));
            let (volume, area) = (unit.powi(D as i32), unit.powi(D as i32 - 1));
            assert_eq!(found.volume, expected.volume * volume, "{options:?}");
            assert_eq!(found.standard_error, expected.standard_error * volume);
            assert_eq!(found.contact_area, expected.contact_area * area);
            assert_eq!(found.penetration, expected.penetration * unit);
            assert_eq!(found.crossing_count, expected.crossing_count);
            for (f, g) in found.forces.iter().flatten().zip(expected.forces.iter().flatten()) {
                assert_eq!(*f, g * area);
            }
        }
    }
}

#[test]
fn unit_of_length_changes_no_bit() {
    (0..4).for_each(|seed| unit_does_not_matter(&plane_scene(seed)));
    (0..2).for_each(|seed| unit_does_not_matter(&solid_scene(seed)));
}
