//! What a file means for its mesh, and its solution.
//!
//! `bodies` (connected parts of the mesh) · `notes` (what is taken in another sense) ·
//! `pairs` (who touches, rubs or is tied) · `timed` (a value over a step) · `state` (what is held
//! and loaded, step after step) · `spread` (loads on faces and volumes) · `solve` (equilibria) · `result` (what a step leaves)

mod bodies;
mod notes;
mod pairs;
mod result;
mod solve;
mod spread;
mod state;
mod timed;

pub(crate) use bodies::{Bodies, Places};
pub use result::{PairResult, StepResult};
pub use solve::{Analysis, SolveOptions, Solved};
