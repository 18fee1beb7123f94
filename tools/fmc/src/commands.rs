//! Commands about cases.

mod interrupt;
pub(crate) mod list;
pub(crate) mod mesh;
#[cfg(feature = "plots")]
pub(crate) mod report;
pub(crate) mod run;
pub(crate) mod solve;
pub(crate) mod study;
mod time_left;
pub(crate) mod verify;
