//! Newton's method for the contact, with bodies that are linear.

use super::bodies::Checked;
use super::dense::{Defect, if_definite, solve_definite, solve_general};
use super::iterate::Iterate;
#[cfg(feature = "solver")]
use super::large;
use super::options::{ContactStepOptions, ContactStepState};
#[cfg(feature = "solver")]
use super::reduced::Reduced;
use super::touching::{ROUNDING, Touching};
use crate::Error;
use crate::contact::equilibrium::descent::TangentChoice;
use crate::contact::tangents::TangentPart;
use nalgebra::{DMatrix, DVector};

/// What a search has taken so far.
pub(super) struct Search {
    pub(super) iterations: usize,
    pub(super) evaluations: usize,
    /// The bodies factorised for systems that are solved on what contact touches alone, once there was one.
    #[cfg(feature = "solver")]
    reduced: Option<Option<Reduced>>,
}

impl Search {
    pub(super) fn new(evaluations: usize) -> Self {
        Self {
            iterations: 0,
            evaluations,
            #[cfg(feature = "solver")]
            reduced: None,
        }
    }

    /// Solution of a large system with an energy, by what the contact touches: `Some(None)` where it is not positive definite,
    /// `None` where this is not the way.
    #[cfg(feature = "solver")]
    fn reduced(
        &mut self,
        bodies: &Checked,
        contact: &dyn Touching,
        at: &Iterate,
        tangent: &DMatrix<f64>,
        right: &DVector<f64>,
    ) -> Option<Option<DVector<f64>>> {
        if bodies.count() < large::FROM {
            return None;
        }
        let new = || Reduced::new(&bodies.symmetric, contact, at, tangent);
        let reduced = self.reduced.get_or_insert_with(new).as_mut()?;
        Some(reduced.solve(&bodies.symmetric, contact, at, tangent, right))
    }

    #[cfg(not(feature = "solver"))]
    fn reduced(
        &mut self,
        _: &Checked,
        _: &dyn Touching,
        _: &Iterate,
        _: &DMatrix<f64>,
        _: &DVector<f64>,
    ) -> Option<Option<DVector<f64>>> {
        None
    }
}

/// From an iterate to the equilibrium, or as near as it gets.
pub(super) fn newton(
    bodies: &Checked,
    contact: &mut dyn Touching,
    options: &ContactStepOptions,
    has_energy: bool,
    search: &mut Search,
    mut at: Iterate,
) -> Result<(Iterate, ContactStepState), Error> {
    let mut choice = TangentChoice::default();
    let last = search.iterations + options.max_iterations;
    loop {
        let (goal, scale) = bodies.goal(options, &at.touch.forces);
        if at.touch.outside(goal) > 0 {
            return Ok((at, ContactStepState::Outside));
        }
        if at.norm() <= goal {
            return Ok((at, ContactStepState::Converged));
        }
        if search.iterations == last {
            return Ok((at, ContactStepState::NotConverged));
        }
        let wish = wish(&choice, options, &at, scale, has_energy);
        let (direction, tangent, part) = direction(bodies, contact, search, &at, wish, has_energy)?;
        search.iterations += 1;
        let (next, trials) = at.after(bodies, contact, &direction, options, has_energy)?;
        search.evaluations += trials;
        choice.made(part, &at.descent(), next.as_ref().map(Iterate::descent).as_ref());
        match next {
            Some(next) => at = next,
            // The semidefinite tangent has not been tried here.
            None if has_energy && part == TangentPart::Full => {}
            None if at.norm() <= rounding(bodies, contact, &at, &tangent) => {
                return Ok((at, ContactStepState::Converged));
            }
            None => return Ok((at, ContactStepState::NotConverged)),
        }
    }
}

/// The tangent to begin with; the full one where there is no energy.
pub(super) fn wish(
    choice: &TangentChoice,
    options: &ContactStepOptions,
    at: &Iterate,
    scale: f64,
    has_energy: bool,
) -> TangentPart {
    if has_energy { choice.wish(at.norm(), options.full_below, scale) } else { TangentPart::Full }
}

/// Newton's direction, with the contact's tangent and the part of it that was taken.
pub(super) fn direction(
    bodies: &Checked,
    contact: &mut dyn Touching,
    search: &mut Search,
    at: &Iterate,
    wish: TangentPart,
    has_energy: bool,
) -> Result<(DVector<f64>, DMatrix<f64>, TangentPart), Error> {
    let right = -&at.residual;
    let told = |contact: &dyn Touching, defect| match defect {
        Defect::Singular { row } => Error::SingularStiffness { dof: contact.dof(row) },
        Defect::Indefinite { row, pivot } => Error::IndefiniteStiffness { dof: contact.dof(row), pivot },
    };
    if !has_energy {
        let tangent = contact.tangent(&at.displacement, wish)?;
        let matrix = finite(&bodies.stiffness + &tangent)?;
        let found = solve_general(&matrix, &right).map_err(|defect| told(contact, defect))?;
        return Ok((found, tangent, wish));
    }
    if wish == TangentPart::Full {
        let tangent = finite(contact.tangent(&at.displacement, wish)?)?;
        let found = match search.reduced(bodies, contact, at, &tangent, &right) {
            Some(found) => found,
            None => if_definite(&(&bodies.symmetric + &tangent), &right).ok(),
        };
        if let Some(found) = found {
            return Ok((found, tangent, wish));
        }
    }
    let part = TangentPart::Semidefinite;
    let tangent = finite(contact.tangent(&at.displacement, part)?)?;
    if let Some(Some(found)) = search.reduced(bodies, contact, at, &tangent, &right) {
        return Ok((found, tangent, part));
    }
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
