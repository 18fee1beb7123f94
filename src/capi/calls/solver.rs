//! Equilibrium of the contact with condensed bodies, their condensation, and the adjoint of an equilibrium.

pub(super) mod adjoint;
pub(super) mod condensation;
pub(super) mod contact_step;
pub(super) mod equilibrium;
