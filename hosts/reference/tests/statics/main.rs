//! Bodies at rest.

mod scene;

mod counts;
mod depth;
mod friction;
mod hertz;
mod patch;
mod pin;
mod refusals;
mod swallowed;
mod tips;
