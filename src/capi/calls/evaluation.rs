//! Forces without a context, and forces with the tangent.

pub(super) mod evaluate_tangent;
pub(super) mod stateless;
pub(super) mod stateless_step;
