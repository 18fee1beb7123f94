//! Explicit dynamics against closed forms and against what must always hold.

mod conservation;
mod free_motion;
mod friction;
mod oscillator;
mod refusals;
mod restart;
mod scene;
mod step_limit;
