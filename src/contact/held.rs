//! What holds bodies together: ties, what slides and does not separate, cohesive interfaces and those by a law of the host are found, kept and asked alike.
//!
//! `found` (what is found between two surfaces) · `list` (all of one kind) · `past` (what interfaces with a history are asked with)

mod found;
mod list;
mod past;

pub(super) use found::{At, Finder, Found, Wanted};
pub(super) use list::{Held, HeldList, Key};
pub(super) use past::{Damage, LawHistory, Past};
