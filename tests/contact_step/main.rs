//! Equilibrium of the contact with condensed bodies.

mod constrained;
mod equilibrium;
mod moved_out;
mod penetration;
mod refused;
mod soft_start;
mod springs;
