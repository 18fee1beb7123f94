//! Rigid shapes that are added, moved and removed.

pub(super) mod obstacle;
pub(super) mod obstacle_list;
pub(super) mod obstacle_rotations;
