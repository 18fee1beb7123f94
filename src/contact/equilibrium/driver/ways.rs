//! Ways to an equilibrium.
//!
//! `settle` (with `quadratic`): rigid motions of loose bodies · `falling_load`: multipliers of another load · `unchanged`: a step in which nothing changes · `unloaded`: bodies
//! whose load is gone · `stuck`: what friction was borne with · `levels`: bodies condensed · `nearest` (with `secant`, `turned`): whole steps · `softly`: friction
//! that sticks softly first · `downhill` (with `along`): down the energy

pub(crate) mod along;
pub(crate) mod downhill;
pub(crate) mod falling_load;
pub(crate) mod levels;
pub(crate) mod nearest;
pub(crate) mod quadratic;
pub(crate) mod secant;
pub(crate) mod settle;
pub(crate) mod softly;
pub(crate) mod stuck;
pub(crate) mod turned;
pub(crate) mod unchanged;
pub(crate) mod unloaded;
