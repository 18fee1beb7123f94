//! What hosts call: `contact` (the functions of [`Contact`](crate::Contact)) · `ties` (of bodies that are tied) ·
//! `stateless` (all in one call)

mod contact;
mod offsets;
mod stateless;
mod ties;

pub use stateless::{FrictionStep, contact_force, contact_force_step};
