//! The heat of friction.

/// The energy that friction has dissipated since the step began, as heat: its sum is that of all pairs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrictionHeat {
    /// By node.
    pub nodes: Vec<f64>,
    /// By obstacle.
    pub of_obstacles: Vec<f64>,
}
