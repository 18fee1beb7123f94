//! The reference host of fmc-contact: a small finite element code that uses the module through its public API alone.
//!
//! [`fem`] holds bodies of first-order elements (internal force, tangent, mass, stress), [`mesh`] reads and writes files.
//! The command `fmc` stands on top.

pub mod fem;
pub mod mesh;
