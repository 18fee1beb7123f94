//! Bodies at rest.

mod scene;

mod depth;
mod hertz;
mod patch;
mod refusals;
