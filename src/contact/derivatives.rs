//! Derivatives of energy and forces by what they depend on, for design, identification and learning.
//!
//! `request` (what is differentiated, and by what) · `gradients` (what comes out) · `answers` (from what the laws answer) ·
//! `obstacle_row` (by how obstacles stand) · `sliders` (by the slip between steps, and what that hangs on) · `directions` and `slopes`
//! (along a direction)

mod answers;
mod directions;
mod gradients;
mod obstacle_row;
mod request;
mod sliders;
mod slopes;

pub(super) use answers::{State, add_answers};
pub(super) use directions::Along;
pub use directions::Directions;
pub use gradients::{Gradients, PairGradient};
pub use request::GradientRequest;
pub(super) use request::{Seeds, SlipSeeds};
pub(super) use sliders::{add_slider_slopes, add_sliders};
pub use slopes::Slopes;
pub(super) use slopes::add_slopes;
