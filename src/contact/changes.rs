//! What a change of one part of a contact means for the others.
//!
//! `options` (of all pairs and of one, obstacles) · `friction_steps` (steps begun and committed, friction frozen) · `patches` (kept) ·
//! `adjustment` (gaps closed, overlaps removed) · `added_ties` (beside the options of pairs) · `poses` (obstacles at another time)

pub(super) mod added_ties;
pub(super) mod adjustment;
pub(super) mod friction_steps;
pub(super) mod options;
pub(super) mod patches;
pub(crate) mod poses;

pub use adjustment::Adjustment;
