//! Sparse symmetric systems.

mod factorisation;
mod lower;

pub use factorisation::Factorisation;
pub use lower::{Entries, Lower};
