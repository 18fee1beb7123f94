//! Newton's method for the contact, with bodies that are linear.

use super::bodies::Checked;
use super::dense::{Defect, solve_definite, solve_general};
use super::iterate::Iterate;
use super::options::{ContactStep, ContactStepOptions, ContactStepState};
use super::touching::{ROUNDING, Touching};
use crate::Error;
use crate::contact::tangent::TangentPart;
use nalgebra::{DMatrix, DVector};

/// From a displacement; `left_over` is the part of the residual there that may be left in any case.
pub(super) fn solve(
    bodies: &Checked,
    contact: &mut dyn Touching,
    start: DVector<f64>,
    options: &ContactStepOptions,
    has_energy: bool,
    left_over: f64,
) -> Result<ContactStep, Error> {
    let mut at = Iterate::new(bodies, contact, start)?;
    let residual_at_start = at.norm();
    let (mut iterations, mut evaluations, mut full_failed) = (0, 1, false);
    let state = loop {
        let (goal, scale) = bodies.goal(options, &at.touch.forces);
        if at.touch.outside(goal) > 0 {
            break ContactStepState::Outside;
        }
        if at.norm() <= goal.max(left_over * residual_at_start) {
            break ContactStepState::Converged;
        }
        if iterations == options.most_iterations {
            break ContactStepState::NotConverged;
        }
        let is_far = at.norm() > options.full_below * scale;
        let wish = match has_energy {
            true if is_far || full_failed => TangentPart::Semidefinite,
            _ => TangentPart::Full,
        };
        let (direction, tangent, part) = direction(bodies, contact, &at, wish, has_energy)?;
        iterations += 1;
        let (next, trials) = at.after(bodies, contact, &direction, options, has_energy)?;
        evaluations += trials;
        match next {
            Some(next) => {
                full_failed = part == TangentPart::Full && next.norm() > 0.5 * at.norm();
                at = next;
            }
            // The semidefinite tangent has not been tried here.
            None if has_energy && part == TangentPart::Full => full_failed = true,
            None if at.norm() <= rounding(bodies, contact, &at, &tangent) => break ContactStepState::Converged,
            None => break ContactStepState::NotConverged,
        }
    };
    let (goal, scale) = bodies.goal(options, &at.touch.forces);
    Ok(ContactStep {
        state,
        iterations,
        evaluations,
        residual_at_start,
        residual: at.norm(),
        scale,
        outside: at.touch.outside(goal),
        displacement: at.displacement.as_slice().to_vec(),
        updates: 0,
        penetration: 0.0,
    })
}

/// Newton's direction, with the contact's tangent and the part of it that was taken.
fn direction(
    bodies: &Checked,
    contact: &mut dyn Touching,
    at: &Iterate,
    wish: TangentPart,
    has_energy: bool,
) -> Result<(DVector<f64>, DMatrix<f64>, TangentPart), Error> {
    let right = -&at.residual;
    let told = |contact: &dyn Touching, defect| match defect {
        Defect::Singular { row } => Error::SingularStiffness { freedom: contact.freedom(row) },
        Defect::Indefinite { row, pivot } => Error::IndefiniteStiffness { freedom: contact.freedom(row), pivot },
    };
    if !has_energy {
        let tangent = contact.tangent(&at.displacement, wish)?;
        let matrix = finite(&bodies.stiffness + &tangent)?;
        let found = solve_general(&matrix, &right).map_err(|defect| told(contact, defect))?;
        return Ok((found, tangent, wish));
    }
    if wish == TangentPart::Full {
        let tangent = contact.tangent(&at.displacement, wish)?;
        if let Ok(found) = solve_definite(&finite(&bodies.symmetric + &tangent)?, &right) {
            return Ok((found, tangent, wish));
        }
    }
    let part = TangentPart::Semidefinite;
    let tangent = contact.tangent(&at.displacement, part)?;
    let matrix = finite(&bodies.symmetric + &tangent)?;
    let found = solve_definite(&matrix, &right).map_err(|defect| told(contact, defect))?;
    Ok((found, tangent, part))
}

fn finite(matrix: DMatrix<f64>) -> Result<DMatrix<f64>, Error> {
    match matrix.iter().copied().find(|value| !value.is_finite()) {
        Some(value) => Err(Error::Overflow { quantity: "stiffness of bodies and contact", value }),
        None => Ok(matrix),
    }
}

/// Residual that rounding of displacements and coordinates calls up.
fn rounding(bodies: &Checked, contact: &dyn Touching, at: &Iterate, tangent: &DMatrix<f64>) -> f64 {
    let coords = DVector::from_fn(bodies.count(), |place, _| contact.start(place).abs());
    let of_bodies = bodies.stiffness.abs() * at.displacement.abs();
    ROUNDING * (of_bodies + tangent.abs() * (coords + at.displacement.abs())).norm()
}
