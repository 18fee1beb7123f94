//! `include/fmc_contact.h`, written down for Rust: the functions that the fuzz target calls, and their structs.
//!
//! A test holds the names against the header, both ways: `tests/pages.rs`.
// The header documents them.
#![allow(missing_docs, non_camel_case_types)]

mod augment;
mod condensation;
mod contact_step;
mod evaluation;
mod fields;
mod friction;
mod mesh;
mod obstacles;
mod options;
mod ranks;
mod status;
mod tangent;

pub use augment::*;
pub use condensation::*;
pub use contact_step::*;
pub use evaluation::*;
pub use fields::*;
pub use friction::*;
pub use mesh::*;
pub use obstacles::*;
pub use options::*;
pub use ranks::*;
pub use status::*;
pub use tangent::*;

/// The library with its C entry points, so that the linker takes it in.
pub use fmc_contact as library;
