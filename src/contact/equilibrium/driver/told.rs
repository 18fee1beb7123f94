//! What is said of an equilibrium, or of why there is none.
//!
//! `overlaps` (which loads do not explain) · `passed` (obstacles moved through bodies) · `half_turns` (of obstacles that rub) · `held` (overlaps that nothing can part) · `held_apart` (supports that contradict a tie) · `uncommitted` (steps that were
//! never accepted) · `locking` (glue too stiff for cells that do not match) · `rounded` (forces hardly more than rounding) · `standing` (whether bodies that only contact
//! holds stand) · `told_breaking` (interfaces that break on the way)

pub(crate) mod half_turns;
pub(crate) mod held;
pub(crate) mod held_apart;
pub(crate) mod locking;
pub(crate) mod overlaps;
pub(crate) mod passed;
pub(crate) mod rounded;
pub(crate) mod standing;
pub(crate) mod told_breaking;
pub(crate) mod uncommitted;
