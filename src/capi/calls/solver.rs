//! Equilibrium of the contact with condensed bodies, and their condensation.

pub(super) mod condensation;
pub(super) mod contact_step;
pub(super) mod equilibrium;
