//! Rules by which contact and bodies come into equilibrium, whatever solves the bodies.
//!
//! [`descent`] says how far to go along a step, and with which tangent the next one is found. The contact step is Newton's
//! method with bodies that are linear, condensed on the degrees of freedom on which contact acts. Multipliers move surfaces out until they
//! press with as little penetration as is wanted. The adjoint gives derivatives of what is found.

mod adjoint;
mod augmentation;
mod contact_step;
pub mod descent;
mod driver;
mod layer_stiffness;
mod mass_stiffness;
mod step_limit;

pub use adjoint::{Adjoint, Goal};
pub use augmentation::Augmentation;
pub use contact_step::{CondensedBodies, ContactStep, ContactStepOptions, ContactStepState, Place};
pub use driver::{Answer, DriverOptions, Equilibrium, Found, Next, Refusal, Request, StepLimit, Unheld, Unknowns, Way};
