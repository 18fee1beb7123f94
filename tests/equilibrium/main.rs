//! The search for an equilibrium, with a host of linear quadrilaterals and dense matrices.

mod bodies;
mod held;
mod loose;
mod protocol;
mod refused;
