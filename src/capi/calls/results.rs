//! What was found beside nodal forces.

pub(super) mod cohesive;
pub(super) mod contact_points;
pub(super) mod flux;
pub(super) mod gap_constraints;
pub(super) mod getters;
pub(super) mod gradients;
pub(super) mod law_points;
pub(super) mod nodal_contact;
pub(super) mod ties;
