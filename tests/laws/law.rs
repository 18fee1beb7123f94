//! Energy law and where its stiffness comes from.

use crate::pairs::plane_scene;
use crate::scene::Scene;
use crate::scene::{exact, lines};
use fmc_contact::contact::{StiffnessFrom, suggest_stiffness};
use fmc_contact::{EnergyLaw, Error, Options};
use fmc_shapes::{Diagonals, cuboid_hex8, rectangle_tri3};

const LAWS: [(f64, f64); 6] = [(1.0, 1.0), (3.0, 1.0), (1e6, 1.25), (0.5, 2.0), (2.0, 2.5), (1e-3, 4.0)];

#[test]
fn traction_is_the_slope_of_the_energy() {
    for (k, m) in LAWS {
        let law = EnergyLaw::Volume { stiffness: k, exponent: m };
        for volume in [1e-9, 1e-3, 0.5, 7.0] {
            let expected = k * f64::powf(volume, m);
            assert!((law.energy(volume) / expected - 1.0).abs() < 1e-14);
            // Truncation of the differences: (h/V)² = 1e-10.
            let h = 1e-5 * volume;
            let slope = (law.energy(volume + h) - law.energy(volume - h)) / (2.0 * h);
            assert!((law.energy_gradient(volume) / slope - 1.0).abs() < 1e-9);
        }
        // No overlap, no energy; and none from a rounding error below zero.
        assert_eq!((law.energy(0.0), law.energy(-1e-20)), (0.0, 0.0));
        assert_eq!(law.energy_gradient(0.0), if m == 1.0 { k } else { 0.0 });
    }
    assert_eq!(EnergyLaw::volume(2.5), EnergyLaw::Volume { stiffness: 2.5, exponent: 1.0 });
}

/// Forces of any law are those of k = 1, m = 1, times one number per pair.
#[test]
fn forces_are_traction_times_gradient() {
    let scene = plane_scene(2);
    for options in [exact(), lines(0.02, 1)] {
        let of_volume = scene.evaluate(options);
        for (k, m) in LAWS {
            let law = EnergyLaw::Volume { stiffness: k, exponent: m };
            let found = scene.evaluate(Options { law, ..options });
            let traction = k * m * of_volume.volume.powf(m - 1.0);
            assert!((found.pairs[0].pressure / traction - 1.0).abs() < 1e-14);
            assert!((found.energy / (k * of_volume.volume.powf(m)) - 1.0).abs() < 1e-14);
            for (f, g) in found.forces.iter().flatten().zip(of_volume.forces.iter().flatten()) {
                assert!((f - traction * g).abs() <= 1e-14 * (traction * g).abs());
            }
            assert_eq!(found.volume, of_volume.volume);
        }
    }
}

/// The pressure expected, 1.2 times, at the overlap accepted: what a block that deep in another is pushed with.
#[test]
fn stiffness_from_a_pressure_resists_that_pressure() {
    let (pressure, depth) = (3.0e5, 0.02);
    for m in [1.0, 1.5, 2.0, 3.0] {
        let square = |y: f64| rectangle_tri3([0.0, y], [0.5, y + 1.0], [2, 2], Diagonals::Same);
        let k = suggest_stiffness(StiffnessFrom::PeakPressure { pressure, overlap: 0.5 * depth }, 2, m).unwrap();
        let law = EnergyLaw::Volume { stiffness: k, exponent: m };
        let contact = Scene::of(&[&square(0.0), &square(1.0 - depth)]).evaluate(Options { law, ..exact() });
        // The overlap is a difference of coordinates of 1.
        assert!((contact.bodies[1].force[1] / (1.2 * pressure * 0.5) - 1.0).abs() < 1e-12);
        let cube = |z: f64| cuboid_hex8([0.0, 0.0, z], [0.5, 0.4, z + 1.0], [2; 3]);
        let k = suggest_stiffness(StiffnessFrom::PeakPressure { pressure, overlap: 0.2 * depth }, 3, m).unwrap();
        let law = EnergyLaw::Volume { stiffness: k, exponent: m };
        let contact = Scene::of(&[&cube(0.0), &cube(1.0 - depth)]).evaluate(Options { law, ..exact() });
        assert!((contact.bodies[1].force[2] / (1.2 * pressure * 0.2) - 1.0).abs() < 1e-12);
    }
}

/// The traction is the modulus when a patch one facet wide is a tenth of a facet deep.
#[test]
fn stiffness_from_a_modulus_resists_it_at_a_tenth_of_a_facet() {
    let (modulus, facet_size) = (2.1e11, 0.25);
    for (dimension, overlap) in [(2, 0.025 * 0.25), (3, 0.025 * 0.0625)] {
        for m in [1.0, 1.5, 2.0, 3.0] {
            let k = suggest_stiffness(StiffnessFrom::Modulus { modulus, facet_size }, dimension, m).unwrap();
            let traction = EnergyLaw::Volume { stiffness: k, exponent: m }.energy_gradient(overlap);
            assert!((traction / modulus - 1.0).abs() < 1e-13, "{traction}");
        }
    }
}

#[test]
fn stiffness_from_nonsense_is_refused() {
    let refused = |from, m| matches!(suggest_stiffness(from, 3, m), Err(Error::NotPositive { .. }));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(refused(StiffnessFrom::Modulus { modulus: bad, facet_size: 1.0 }, 1.0));
        assert!(refused(StiffnessFrom::Modulus { modulus: 1.0, facet_size: bad }, 2.0));
        assert!(refused(StiffnessFrom::PeakPressure { pressure: bad, overlap: 1.0 }, 1.0));
        assert!(refused(StiffnessFrom::PeakPressure { pressure: 1.0, overlap: bad }, 2.0));
    }
    for m in [0.99, 0.0, -1.0, f64::NAN] {
        assert!(refused(StiffnessFrom::Modulus { modulus: 1.0, facet_size: 1.0 }, m));
    }
}
