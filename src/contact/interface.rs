//! What hosts call: [`Contact`], and all in one call.

mod contact;
mod stateless;

pub use contact::Contact;
pub use stateless::{FrictionStep, contact_force, contact_force_step};
