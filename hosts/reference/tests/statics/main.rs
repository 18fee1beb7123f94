//! Bodies at rest.

mod scene;

mod hertz;
mod patch;
mod refusals;
