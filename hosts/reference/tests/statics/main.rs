//! Bodies at rest.

mod scene;

mod hertz;
mod indentation;
mod patch;
mod refusals;
