//! The reference host of fmc-contact: a small finite element code that uses the module through its public API alone.
//!
//! [`fem`] holds bodies of first-order elements (internal force, tangent, mass, stress), [`dynamics`] moves them through
//! time, [`case`] reads benchmark problems as data, [`run`](mod@run) carries them out and [`study`] compares ways to
//! solve them. [`mesh`] reads and writes files, [`chart`] draws pictures.
//! The command `fmc` stands on top.

pub mod case;
pub mod chart;
pub mod dynamics;
pub mod fem;
pub mod mesh;
pub mod rotation;
pub mod run;
pub mod statics;
pub mod study;
mod viridis;

pub use viridis::viridis;
