//! Ranks that share the work of a contact.

#[path = "../scene/scene.rs"]
mod scene;

mod communicator;

mod failures;
mod partition;
mod parts;
mod same_bits;
mod shares;
