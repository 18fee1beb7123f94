//! The order of things in a load step.
//!
//! `load_step` (all of it) · `parts` (what is prescribed, part by part) · `attempt` (each way from a place) · `first_touch` (from where slip counts) · `check` (whether a host is one)

pub(crate) mod attempt;
pub(crate) mod check;
pub(crate) mod first_touch;
pub(crate) mod load_step;
pub(crate) mod parts;
