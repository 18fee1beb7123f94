//! What hosts call: `contact` (the functions of [`Contact`](crate::Contact)) · `stateless` (all in one call)

mod contact;
mod offsets;
mod stateless;

pub use stateless::{FrictionStep, contact_force, contact_force_step};
