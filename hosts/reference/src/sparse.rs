//! Sparse systems.

mod condensed;
mod dissection;
mod factorisation;
mod graph;
mod lower;
mod near;
mod order;
mod schur;
mod triangle;
mod unsymmetric;

pub use condensed::Condensed;
pub use factorisation::Factorisation;
pub use lower::{Entries, Lower};
pub use schur::Schur;
pub use unsymmetric::solve_unsymmetric;
