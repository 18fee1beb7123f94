//! What cannot be solved is refused by name, and changes nothing.

use crate::springs::{SPRING, square};
use fmc_contact::Error;
use fmc_contact::contact::{CondensedBodies, ContactStepOptions};

fn refused(dofs: &[usize], held: &[usize], stiffness: &[f64], residual: &[f64]) -> Error {
    let (coords, contact) = square(-0.05);
    let before = contact.evaluate(&coords).unwrap();
    let bodies = CondensedBodies { dofs, held, stiffness, residual };
    let error = contact.contact_step(&coords, &bodies, &ContactStepOptions::default(), None).unwrap_err();
    assert_eq!(contact.evaluate(&coords).unwrap(), before);
    error
}

#[test]
fn lists_and_arrays_are_looked_at() {
    let dof = |dof, count| Error::DofOutOfRange { dof, count };
    assert_eq!(refused(&[1, 8], &[], &[0.0; 4], &[0.0; 2]), dof(8, 8));
    assert_eq!(refused(&[1], &[9], &[0.0; 1], &[0.0; 1]), dof(9, 8));
    assert_eq!(refused(&[3, 1], &[], &[0.0; 4], &[0.0; 2]), Error::RepeatedDof { dof: 1 });
    assert_eq!(refused(&[1, 1], &[], &[0.0; 4], &[0.0; 2]), Error::RepeatedDof { dof: 1 });
    assert_eq!(refused(&[1, 3], &[3], &[0.0; 4], &[0.0; 2]), Error::RepeatedDof { dof: 3 });
    let length = |array, expected, found| Error::Length { array, expected, found };
    assert_eq!(refused(&[1, 3], &[], &[0.0; 4], &[0.0; 1]), length("residual", 2, 1));
    assert_eq!(refused(&[1, 3], &[], &[0.0; 3], &[0.0; 2]), length("stiffness", 4, 3));
    let entry = |array, entry| Error::NonFiniteStiffness { array, entry };
    assert_eq!(refused(&[1, 3], &[], &[0.0, 0.0, f64::NAN, 0.0], &[0.0; 2]), entry("stiffness", 2));
    assert_eq!(refused(&[1, 3], &[], &[0.0; 4], &[0.0, f64::INFINITY]), entry("residual", 1));
}

#[test]
fn options_out_of_their_range_are_named() {
    let (coords, contact) = square(-0.05);
    let bodies = CondensedBodies { dofs: &[], held: &[], stiffness: &[], residual: &[] };
    let plain = ContactStepOptions::default();
    for (name, options) in [
        ("tolerance", ContactStepOptions { tolerance: 0.0, ..plain }),
        ("absolute_tolerance", ContactStepOptions { absolute_tolerance: -1.0, ..plain }),
        ("absolute_tolerance", ContactStepOptions { absolute_tolerance: f64::NAN, ..plain }),
        ("full_below", ContactStepOptions { full_below: f64::NAN, ..plain }),
        ("max_iterations", ContactStepOptions { max_iterations: 0, ..plain }),
        ("max_trials", ContactStepOptions { max_trials: 0, ..plain }),
    ] {
        let error = contact.contact_step(&coords, &bodies, &options, None).unwrap_err();
        assert!(matches!(error, Error::NotPositive { name: found, .. } if found == name), "{error}");
    }
}

/// The plane holds the square up, and springs are what holds it sideways.
#[test]
fn bodies_that_nothing_holds_are_told_from_those_that_give_way() {
    let upright = |sideways: f64| {
        let mut stiffness = [0.0; 16];
        (stiffness[0], stiffness[10]) = (sideways, sideways);
        stiffness
    };
    let residual = [0.0, 1.0, 0.0, 1.0];
    let dofs = [0, 1, 2, 3];
    assert_eq!(refused(&dofs, &[], &upright(0.0), &residual), Error::SingularStiffness { dof: 0 });
    let pivot = -SPRING;
    let error = refused(&dofs, &[], &upright(pivot), &residual);
    assert_eq!(error, Error::IndefiniteStiffness { dof: 0, pivot });
}

/// The entries are finite, their norm is not: no displacement is an equilibrium beside it. Found by fuzzing.
#[test]
fn a_residual_beyond_the_range_of_a_double_is_told() {
    let error = refused(&[1, 3], &[], &[SPRING, 0.0, 0.0, SPRING], &[1e200; 2]);
    let quantity = "residual of a contact step";
    assert!(matches!(error, Error::Overflow { quantity: found, .. } if found == quantity), "{error}");
}

#[test]
fn a_function_that_fails_is_told() {
    let (coords, contact) = square(-0.05);
    let bodies = CondensedBodies { dofs: &[], held: &[], stiffness: &[], residual: &[] };
    let mut fails = |_: &[f64], _: &mut [[f64; 2]]| Err(Error::Place { code: 7 });
    let options = ContactStepOptions::default();
    let error = contact.contact_step(&coords, &bodies, &options, Some(&mut fails)).unwrap_err();
    assert_eq!(error, Error::Place { code: 7 });
}
