//! What is known of the balance of an overlap's forces.

/// What is expected of ΣF and ΣM, in parts of the sizes of forces and of their moments.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Imbalance {
    /// Up to this the forces stay as they are.
    pub(crate) rounding: f64,
    /// From this on there is a warning.
    pub(crate) doubtful: f64,
}
