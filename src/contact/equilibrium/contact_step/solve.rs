//! From a displacement to the equilibrium of the contact.

use super::bodies::Checked;
use super::iterate::Iterate;
use super::newton::{Search, newton};
use super::options::{ContactStep, ContactStepOptions};
use super::soft_start::settle;
use super::touching::Touching;
use crate::Error;
use nalgebra::DVector;

/// From a displacement; `left_over` is the part of the residual there that may be left in any case.
pub(super) fn solve(
    bodies: &Checked,
    contact: &mut dyn Touching,
    start: DVector<f64>,
    options: &ContactStepOptions,
    has_energy: bool,
    left_over: f64,
) -> Result<ContactStep, Error> {
    let mut start = Iterate::new(bodies, contact, start)?;
    let residual_at_start = start.norm();
    let mut search = Search::new(1, left_over * residual_at_start);
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
        updates: 0,
        penetration: 0.0,
    })
}
