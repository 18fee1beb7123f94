//! What is written: tables, VTU and FRD files.

mod fields;
mod frd;
mod table;
mod vtu;

pub use frd::{frd_start, frd_step};
pub use table::step_table;
pub use vtu::vtu;
