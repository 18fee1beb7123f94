//! Sparse symmetric systems.
//!
//! A crate of its own, since faer's algorithms are compiled where they are first called: here, and not again with every
//! change of the solver and for each of its tests.

mod factorisation;
mod lower;

pub use factorisation::Factorisation;
pub use lower::Lower;
