//! Derivatives of energy and forces by what they depend on, for design, identification and learning.
//!
//! `request` (what is differentiated, and by what) · `gradients` (what comes out) · `answers` (from what the laws answer) ·
//! `obstacle_row` (by how obstacles stand) · `sliders` (by the slip between steps, and what that hangs on)

mod answers;
mod gradients;
mod obstacle_row;
mod request;
mod sliders;

pub(super) use answers::{State, add_answers};
pub use gradients::{Gradients, PairGradient};
pub use request::GradientRequest;
pub(super) use request::{Seeds, SlipSeeds};
pub(super) use sliders::add_sliders;
