//! Friction: tractions along the surfaces, at the points where a law presses.
//!
//! ```text
//! s = e + g      g: slip of two material points that face one another, since the step began, without what both bodies
//!                turned together; e: elastic slip carried into the step
//! q = k_T s      while that is below the limit μ p (stick), else the limit along s (slip)
//! ```
//!
//! `options` · `return_mapping` (from slip to traction) · `step` (the state when the step began) · `side_motion` (how one
//! side moved since) · `slip_points` (the points of a pair with their slip) · `tractions` (forces, tangent and energies of a
//! pair) · `frozen` (points and pressure of an earlier iteration) · `carried_slip` (what a step leaves to the next)

mod carried_slip;
mod frozen;
mod options;
mod return_mapping;
mod side_motion;
mod slip_points;
mod step;
mod tractions;

pub(super) use carried_slip::CarriedSlip;
pub(super) use frozen::FrozenPoints;
pub use options::Friction;
pub(super) use slip_points::SlipPoints;
pub(super) use step::Step;
pub use tractions::FrictionTotals;
pub(super) use tractions::Tractions;
