//! Newton's method for the contact, with bodies that are linear.

use super::bodies::Checked;
use super::dense::{Defect, solve_definite, solve_general};
use super::iterate::Iterate;
use super::options::{ContactStep, ContactStepOptions, ContactStepState};
use crate::Error;
use crate::contact::tangent::TangentPart;
use nalgebra::{DMatrix, DVector};

/// Multiples of a bit by which sums of some thousand terms differ, and so residuals of equilibria.
pub(super) const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Contact at a displacement.
#[derive(Clone, Debug)]
pub(super) struct Touch {
    /// With that of friction, which is its potential where it is frozen.
    pub(super) energy: f64,
    /// On the list.
    pub(super) forces: DVector<f64>,
    /// Those that are not zero on degrees of freedom that are not on the list, nor held.
    pub(super) outside: Vec<f64>,
}

impl Touch {
    /// Number of degrees of freedom outside on which it acts by more than what may be left of a residual: none if and only if
    /// all together do not.
    fn outside(&self, goal: f64) -> usize {
        if DVector::from_column_slice(&self.outside).norm() <= goal {
            return 0;
        }
        // What is smaller everywhere has no larger norm.
        let share = goal / (self.outside.len() as f64).sqrt();
        self.outside.iter().filter(|force| force.abs() > share).count()
    }
}

/// Contact as a function of the displacement.
pub(super) trait Touching {
    fn at(&mut self, displacement: &DVector<f64>) -> Result<Touch, Error>;

    fn tangent(&mut self, displacement: &DVector<f64>, part: TangentPart) -> Result<DMatrix<f64>, Error>;

    /// Number of a degree of freedom of the list among all.
    fn freedom(&self, place: usize) -> usize;

    /// Its coordinate at the start.
    fn start(&self, place: usize) -> f64;
}

pub(super) fn solve(
    bodies: &Checked,
    contact: &mut dyn Touching,
    options: &ContactStepOptions,
    has_energy: bool,
) -> Result<ContactStep, Error> {
    let mut at = Iterate::new(bodies, contact, DVector::zeros(bodies.count()))?;
    let residual_at_start = at.norm();
    let (mut iterations, mut evaluations, mut full_failed) = (0, 1, false);
    let state = loop {
        let (goal, scale) = bodies.goal(options, &at.touch.forces);
        if at.touch.outside(goal) > 0 {
            break ContactStepState::Outside;
        }
        if at.norm() <= goal {
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
