//! Cholesky factors of sparse symmetric matrices, with equations that are kept for the end.

mod condensation;
mod condensed;
mod dissection;
mod factorisation;
mod graph;
mod lower;
mod near;
mod order;
mod schur;
mod symmetric;
mod triangle;
mod unsymmetric;

pub use condensation::Condensation;
pub use condensed::Condensed;
pub use factorisation::Factorisation;
pub use lower::{Entries, Lower};
pub use schur::Schur;
pub use unsymmetric::solve_unsymmetric;
