//! What holds bodies together: ties, what slides and does not separate, and cohesive interfaces are found, kept and asked alike.
//!
//! `found` (what is found between two surfaces) · `list` (all of one kind) · `of_contact` (all kinds of a contact)

mod found;
mod list;
mod of_contact;

pub(super) use found::{At, Finder, Found};
pub(super) use list::{Held, HeldList, Key};
