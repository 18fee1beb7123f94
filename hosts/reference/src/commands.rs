//! Commands about cases.

pub(crate) mod list;
pub(crate) mod mesh;
pub(crate) mod report;
pub(crate) mod run;
pub(crate) mod study;
