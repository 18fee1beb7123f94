//! From the start to the equilibrium of the contact.

use super::bodies::Checked;
use super::iterate::Iterate;
use super::newton::{Search, newton};
use super::options::{ContactStep, ContactStepOptions};
use super::soft_start::settle;
use super::touching::Touching;
use crate::Error;
use nalgebra::DVector;

/// From no displacement on.
pub(super) fn solve(
    bodies: &Checked,
    contact: &mut dyn Touching,
    options: &ContactStepOptions,
    has_energy: bool,
) -> Result<ContactStep, Error> {
    let mut start = Iterate::new(bodies, contact, DVector::zeros(bodies.count()))?;
    let residual_at_start = start.norm();
    let mut search = Search::new(1);
    if options.soft_start {
        start = settle(bodies, contact, options, has_energy, &mut search, start)?;
    }
    let (at, state) = newton(bodies, contact, options, has_energy, &mut search, start)?;
    let (goal, scale) = bodies.goal(options, &at.touch.forces);
    Ok(ContactStep {
        state,
        iterations: search.iterations,
        evaluations: search.evaluations,
        residual_at_start,
        residual: at.norm(),
        scale,
        outside: at.touch.outside(goal),
        displacement: at.displacement.as_slice().to_vec(),
    })
}
