//! The search for an equilibrium, with a host of linear quadrilaterals and dense matrices.

mod adjoint;
mod bodies;
mod falling;
mod held;
mod limit;
mod loose;
mod moved_obstacles;
mod protocol;
mod refused;
mod told_motions;
mod touching;
mod unloaded;
