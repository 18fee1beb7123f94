//! The benchmark problems of fmc-contact, from data to figures.
//!
//! ```text
//! report          every example on one page                 (feature `plots`)
//!    |     \
//! study    verify     solvers side by side; overlap against closed forms
//!    |        |
//!   run       |       a case carried out: history, fields, figures, pictures
//!    |        |
//!   case    chart     problems as data; pictures of curves
//! ```
//!
//! The cases are the TOML files in `benchmarks/cases`, read by every host alike. Without the feature `plots` everything is
//! computed and no picture is drawn.

pub mod case;
pub mod chart;
mod number;
#[cfg(feature = "plots")]
pub mod report;
pub mod run;
pub mod study;
pub mod verify;
