//! The reference host of fmc-contact: a small finite element code that uses the module through its public API alone.
//!
//! [`dynamics`] moves bodies through time, [`fem`] holds bodies of first-order elements (internal force, tangent, mass, stress), [`mesh`] reads and writes files.
//! The command `fmc` stands on top.

pub mod dynamics;
pub mod fem;
pub mod mesh;
