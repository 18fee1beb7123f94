//! Where the fibers lie: each is a pure function of (seed, family or stream, index).

mod family;
mod pattern;
mod segment;
mod stream;

pub(crate) use family::Family;
pub use pattern::FiberPattern;
pub(crate) use segment::Segment;
pub(crate) use stream::uniforms;
