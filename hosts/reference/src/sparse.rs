//! Sparse systems.

mod factorisation;
mod lower;
mod unsymmetric;

pub use factorisation::Factorisation;
pub use lower::{Entries, Lower};
pub use unsymmetric::solve_unsymmetric;
