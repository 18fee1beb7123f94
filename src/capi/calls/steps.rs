//! What is kept from one step to the next: friction, patches, multipliers; and how long a step of explicit dynamics may be.

pub(super) mod adjustment;
pub(super) mod augmentation;
pub(super) mod damage;
pub(super) mod friction;
pub(super) mod friction_history;
pub(super) mod law_history;
pub(super) mod multipliers;
pub(super) mod patches;
pub(super) mod slip;
pub(super) mod stable_step;
pub(super) mod step_limit;
pub(super) mod wear;
