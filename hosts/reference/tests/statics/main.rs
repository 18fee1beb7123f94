//! Bodies at rest.

mod scene;

mod fibers;
mod hertz;
mod indentation;
mod patch;
mod refusals;
