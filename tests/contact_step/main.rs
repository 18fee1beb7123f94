//! Equilibrium of the contact with condensed bodies.

mod equilibrium;
mod refused;
mod soft_start;
mod springs;
