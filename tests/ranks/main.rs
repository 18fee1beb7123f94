//! Ranks that share the work of a contact.

#[path = "../scene/scene.rs"]
mod scene;

mod communicator;

mod bodies_in_parts;
mod carried_over;
mod faces_between;
mod failures;
mod partition;
mod parts;
mod refused_in_parts;
mod same_bits;
mod shares;
