//! How overlap is measured: exactly, by lines, or as each pair needs.

mod auto;
mod by_options;
pub(crate) mod estimator;
mod exact;
mod fibers;

pub(crate) use by_options::estimator;
