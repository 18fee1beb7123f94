//! Forces without a context, and forces with the tangent.

pub(super) mod evaluate;
pub(super) mod evaluate_tangent;
pub(super) mod friction_step;
pub(super) mod stateless;
