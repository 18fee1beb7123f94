//! What holds bodies together: ties, what slides and does not separate, and cohesive interfaces are found, kept and asked alike.
//!
//! `found` (what is found between two surfaces) · `list` (all of one kind) · `past` (what cohesive interfaces are asked with)

mod found;
mod list;
mod past;

pub(super) use found::{At, Finder, Found, Wanted};
pub(super) use list::{Held, HeldList, Key};
pub(super) use past::{Damage, Past};
