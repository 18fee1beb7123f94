//! The unit of length does not matter: with one that is a power of 2, not a bit changes.

use crate::pairs::{plane_scene, solid_scene};
use crate::scene::table::{by_laws, has_pressure_by_length, laws};
use crate::scene::{Scene, exact, fibers};
use fmc_contact::{FiberOptions, FiberPattern, LineWeights, Options};

/// With laws whose lengths are in that unit.
fn estimators(unit: f64) -> Vec<Options> {
    let consistent =
        FiberOptions { weights: LineWeights::Consistent, momentum_correction: false, ..FiberOptions::default() };
    let isotropic = FiberOptions { pattern: FiberPattern::Isotropic { length: None }, ..FiberOptions::default() };
    let by_all = by_laws([exact(), fibers(FiberOptions::default()), fibers(isotropic)], &laws(unit));
    by_all.into_iter().chain([fibers(consistent)]).collect()
}

fn unit_does_not_matter<const D: usize>(scene: &Scene<D>) {
    for power in [-20, -2, 4, 30] {
        let unit = 2f64.powi(power);
        let scaled = scene.clone().mapped(|x| x.map(|x| x * unit));
        for (options, of_one) in estimators(unit).into_iter().zip(estimators(1.0)) {
            let (found, expected) = (scaled.evaluate(options), scene.evaluate(of_one));
            let (volume, area) = (unit.powi(D as i32), unit.powi(D as i32 - 1));
            // All other pressures are k.
            let pressure = if has_pressure_by_length(&options.law) { unit } else { 1.0 };
            assert_eq!(found.energy, expected.energy * pressure * volume);
            assert_eq!(found.volume, expected.volume * volume, "{options:?}");
            assert_eq!(found.standard_error, expected.standard_error * volume);
            assert_eq!(found.contact_area, expected.contact_area * area);
            assert_eq!(found.penetration, expected.penetration * unit);
            assert_eq!(found.crossing_count, expected.crossing_count);
            for (f, g) in found.forces.iter().flatten().zip(expected.forces.iter().flatten()) {
                assert_eq!(*f, g * pressure * area);
            }
        }
    }
}

#[test]
fn unit_of_length_changes_no_bit() {
    (0..4).for_each(|seed| unit_does_not_matter(&plane_scene(seed)));
    (0..2).for_each(|seed| unit_does_not_matter(&solid_scene(seed)));
}
