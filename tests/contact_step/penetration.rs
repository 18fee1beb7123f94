//! As little penetration as is wanted.

use crate::equilibrium::{K, scene};
use crate::springs::{SPRING, square, step};
use fmc_contact::contact::{CondensedBodies, ContactStep, ContactStepOptions, ContactStepState, Friction};
use fmc_contact::{EnergyLaw, Error, Options};
use nalgebra::{DMatrix, DVector};

fn wanted(penetration: f64) -> ContactStepOptions {
    ContactStepOptions { penetration, ..Default::default() }
}

/// A square on springs that a plane stops where it is: without penetration d is the height, whatever k.
#[test]
fn a_plane_stops_a_square() {
    for (height, push) in [(0.1, 20.0), (-0.05, 10.0), (-0.4, 10.0)] {
        for penetration in [1e-3, 1e-6, 1e-10] {
            let found = step(height, push, &wanted(penetration));
            assert_eq!(found.state, ContactStepState::Converged, "{found:?}");
            assert!((found.displacement[1] + height).abs() <= 1.01 * penetration, "{height}: {found:?}");
            assert!(found.penetration <= penetration && found.updates <= 8, "{found:?}");
            assert!(found.iterations <= 30, "{found:?}");
        }
        // What the plane bears: all of the push and of the springs.
        let found = step(height, push, &wanted(1e-10));
        let pressed = -(SPRING * found.displacement[1] + push);
        assert!((pressed - (SPRING * height - push)).abs() < 1e-6, "{pressed}");
    }
}

/// Less than the law leaves is not asked for: nothing is updated, and the answer has the bits of the law's.
#[test]
fn a_law_that_is_stiff_enough_is_left_alone() {
    let (plain, asked) = (step(0.1, 20.0, &ContactStepOptions::default()), step(0.1, 20.0, &wanted(1.0)));
    assert!(asked.penetration > 0.0);
    assert_eq!(ContactStep { penetration: 0.0, ..asked }, plain);
}

/// A membrane over a fan of edges: the same place by a law that is soft or hard, and a solution of the constrained problem. No gap
/// is negative, and what the bodies are pressed with is a sum of the gaps' derivatives where they are closed, by pressures that
/// are not negative: both by a path of their own, least squares on the rows of `gap_constraints`.
#[test]
fn the_constraints_are_met_whatever_the_stiffness_of_the_law() {
    let mut first: Option<DVector<f64>> = None;
    for k in [K, 0.1 * K, 10.0 * K] {
        let scene = scene(EnergyLaw::depth(k), 0.0);
        let (whole, found) = scene.condensed(&wanted(1e-9));
        assert_eq!(found.state, ContactStepState::Converged, "{k:e}: {found:?}");
        assert!(found.penetration <= 1e-9, "{k:e}: {found:?}");
        println!("k {k:e}: {} updates, {} iterations", found.updates, found.iterations);
        let apart = (&whole - &*first.get_or_insert_with(|| whole.clone())).amax();
        assert!(apart < 1e-7, "{k:e}: {apart:e}");

        let gaps = scene.contact.gap_constraints(&scene.at(&whole), 0.1).unwrap();
        let mean = |row: usize| gaps.gaps[row] / gaps.areas[row];
        assert!((0..gaps.gaps.len()).all(|row| mean(row) > -1.1e-9));
        let closed: Vec<usize> = (0..gaps.gaps.len()).filter(|row| mean(*row) < 1e-7).collect();
        let mut slopes = DMatrix::zeros(whole.len(), closed.len());
        for (col, &row) in closed.iter().enumerate() {
            for entry in gaps.row_starts[row]..gaps.row_starts[row + 1] {
                for axis in 0..2 {
                    slopes[(2 * gaps.columns[entry] as usize + axis, col)] += gaps.slopes[entry][axis];
                }
            }
        }
        let pressed = scene.pressed(&whole);
        let pressures = (slopes.transpose() * &slopes).lu().solve(&(slopes.transpose() * &pressed)).unwrap();
        assert!(closed.len() > 1 && pressures.min() > -1e-6 * pressures.max(), "{pressures:?}");
        assert!((&slopes * &pressures - &pressed).amax() < 1e-6 * pressed.amax());
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let (coords, mut contact) = square(0.1);
    let stiffness = [SPRING];
    let bodies = CondensedBodies { freedoms: &[1], held: &[], stiffness: &stiffness, residual: &[0.0] };
    let mut refused = |options: Options| {
        contact.set_options(options).unwrap();
        let error = contact.contact_step(&coords, &bodies, &wanted(1e-6), None).unwrap_err();
        assert!(matches!(error, Error::Unsupported { what } if what.contains("penetration")), "{error}");
    };
    refused(Options { friction: Friction::coulomb(0.3), ..Options::new(EnergyLaw::depth(1.0)) });
    refused(Options { self_contact: true, ..Options::new(EnergyLaw::depth(1.0)) });
    refused(Options::new(EnergyLaw::volume(1.0)));
}
