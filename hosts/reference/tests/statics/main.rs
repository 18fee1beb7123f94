//! Bodies at rest.

mod scene;

mod depth;
mod hertz;
mod patch;
mod pin;
mod refusals;
mod swallowed;
mod tips;
