//! What hosts call: `contact` (the functions of [`Contact`](crate::Contact)) · `gradients` (its derivatives) · `flux` (of scalar fields) · `ties` (of bodies that are
//! tied) · `stateless` (all in one call)

mod contact;
mod flux;
mod gradients;
mod offsets;
mod stateless;
mod ties;

pub use stateless::{FrictionStep, contact_force, contact_force_step};
