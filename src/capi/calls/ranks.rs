//! Ranks that share the work, and meshes that they hold in parts.

pub(super) mod communicator;
pub(super) mod parts;
pub(super) mod parts_creation;
pub(super) mod parts_getters;
