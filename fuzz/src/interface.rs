//! The functions that the fuzz targets call, and their structs: `include/fmc_contact.h`, written down for Rust.
// The header documents them.
#![allow(missing_docs, non_camel_case_types)]

#[rustfmt::skip]
mod declarations;

pub use declarations::*;

/// `FMC_OK`.
pub const OK: fmc_status = FMC_OK;

/// The library with its C entry points, so that the linker takes it in.
pub use fmc_contact as library;
