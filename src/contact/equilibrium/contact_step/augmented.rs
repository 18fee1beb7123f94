//! Equilibrium with as little penetration as is wanted.

use super::bodies::Checked;
use super::kept::Kept;
use super::multipliers::{Multipliers, Update};
use super::options::{ContactStep, ContactStepOptions, ContactStepState};
use super::solve;
use crate::Error;
use crate::contact::evaluation::Contact;
use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use nalgebra::DVector;

/// Part of a penetration that an update may leave; where it leaves more, k is raised by the factor that follows.
const SLOW: f64 = 0.25;
const RAISE: f64 = 4.0;

/// Part of the residual that an update may leave: with the next one the pressures change anyway.
const LEFT_OVER: f64 = 1e-2;

/// Reach of the gaps, by the bodies' extent: what opens farther in one iteration is taken for apart.
const REACH: f64 = 0.05;

/// From the equilibrium with the law on.
pub(super) fn solve<const D: usize>(
    contact: &Contact<D>,
    bodies: &Checked,
    kept: &mut Kept<D>,
    (coords, options): (&[[f64; D]], &ContactStepOptions),
) -> Result<ContactStep, Error> {
    if contact.partners.has_friction(contact.method.options()) || contact.method.options().self_contact {
        return Err(Error::Unsupported { what: "a penetration asked for with friction or self-contact" });
    }
    let what = "a penetration asked for under a law without a stiffness by penetration";
    let stiffness = contact.method.law.initial_stiffness().ok_or(Error::Unsupported { what })?;
    let mut found = solve::solve(bodies, kept, DVector::zeros(bodies.count()), options, true, 0.0)?;
    let mut extent = Aabb::empty();
    coords.iter().for_each(|x| extent.include(&Vector::from(*x)));
    let reach = if options.reach > 0.0 { options.reach } else { REACH * extent.extent().max() };
    let mut law = Multipliers::new(kept, reach, stiffness);
    let mut at = DVector::from_column_slice(&found.displacement);
    let mut update = law.update(&at)?;
    found.penetration = update.penetration;
    let is_near = |update: &Update| update.change.max(update.penetration) <= options.penetration;
    let is_balanced = |step: &ContactStep| step.residual <= options.goal.max(options.tolerance * step.scale);
    let plain = ContactStepOptions { soft_start: false, ..*options };
    // The law alone may be enough.
    let mut is_done = update.penetration <= options.penetration;
    while found.state == ContactStepState::Converged && !is_done {
        if found.updates == options.most_updates {
            found.state = ContactStepState::NotConverged;
            break;
        }
        let (before, last) = (found, update);
        let left_over = if is_near(&last) { 0.0 } else { LEFT_OVER };
        found = solve::solve(bodies, &mut law, at, &plain, false, left_over)?;
        at = DVector::from_column_slice(&found.displacement);
        update = law.update(&at)?;
        found.penetration = update.penetration;
        found.updates = before.updates + 1;
        found.iterations += before.iterations;
        found.evaluations += before.evaluations;
        found.residual_at_start = before.residual_at_start;
        is_done = is_near(&update) && is_balanced(&found);
        if update.change > SLOW * last.change && !is_near(&update) {
            law.stiffness *= RAISE;
        }
    }
    Ok(found)
}
