//! Studies: one problem solved in several ways, side by side.
//!
//! [`Impact`] runs an impact with every [`Method`] of measuring overlap and with the laws w = k V and w = k V²: what
//! each does to energy, impulse and balance, and what it costs.

mod attempt;
mod files;
mod impact;
mod method;
mod table;

pub use attempt::{Attempt, Outcome};
pub use files::write;
pub use impact::{Impact, Progress};
pub use method::Method;
pub use table::table;
