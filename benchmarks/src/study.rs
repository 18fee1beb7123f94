//! Studies: one problem solved in several ways, side by side.
//!
//! [`Impact`] runs an impact with every [`Method`] of measuring overlap and with the laws w = k V and w = k V²: what
//! each does to energy, impulse and balance, and what it costs. [`SolverStudy`] sets Newton's method on the fiber law beside
//! the paper's loop on an equilibrium, and [`Convergence`] refines mesh and fibers of one.

mod attempt;
mod convergence;
mod files;
mod impact;
mod method;
mod newton;
mod table;

pub use attempt::{Attempt, Outcome};
pub use convergence::{Convergence, Refined};
pub use files::write;
pub use impact::{Impact, Progress};
pub use method::Method;
pub use newton::{Solution, SolverStudy};
pub use table::table;
