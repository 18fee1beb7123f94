//! What is carried from one evaluation to the next: `friction_steps` (begun, committed, restarted) · `kept_patches`

mod friction_steps;
mod kept_patches;
