//! The functions of the header, in rooms as its sections are. They check what they are given, and hand it to the context.

pub(super) mod evaluation;
pub(super) mod mesh;
pub(super) mod obstacles;
pub(super) mod options;
pub(super) mod ranks;
pub(super) mod results;
pub(super) mod solver;
pub(super) mod steps;
pub(super) mod tangent;
pub(super) mod version;

#[cfg(test)]
mod tests;
