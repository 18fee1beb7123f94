//! Bodies at rest.

mod scene;

mod counts;
mod depth;
mod friction;
mod hertz;
mod patch;
mod pin;
mod refusals;
mod rigid;
mod swallowed;
mod tips;
