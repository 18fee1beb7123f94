//! Sparse systems: what a host needs to condense its bodies on what feels contact. Cholesky factors are faer's; the order of
//! elimination, with some equations for the end, and what is left on them are found here.

mod compressed;
#[cfg(feature = "solver")]
mod factors;
#[cfg(not(feature = "solver"))]
mod without;

pub use compressed::Compressed;
#[cfg(feature = "solver")]
pub use factors::{Condensation, Condensed, Entries, Factorisation, Lower, Schur, solve_unsymmetric};
#[cfg(not(feature = "solver"))]
pub use without::Condensation;
