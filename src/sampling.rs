//! Where the fibers lie.

mod pattern;

pub use pattern::FiberPattern;
