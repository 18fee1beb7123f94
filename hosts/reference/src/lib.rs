//! Elastic bodies in contact, at rest and in motion: a small finite element code over fmc-contact's public API.
//!
//! ```text
//! statics   dynamics      equilibrium by Newton's method; explicit leapfrog
//!       \    |
//!        fem              bodies of cells
//! ```
//!
//! [`fem::Part`] is one body: a [`Mesh`] of one cell type and its material. A [`fem::Model`] holds the bodies of a problem
//! under one numbering of nodes, and gives their force, stiffness, mass and stress. [`statics`] finds where they rest,
//! [`dynamics`] moves them through time; both take the contact's options and the rigid obstacles as fmc-contact has them.
//! Everything is SI, two dimensions are plane strain per metre of thickness, and the same input gives the same bits with
//! any number of threads.
//!
//! `examples/disc_at_rest.rs` and `examples/bar_impact.rs` are complete programs.

pub mod dynamics;
pub mod fem;
pub mod statics;

pub use fmc_shapes::Mesh;
