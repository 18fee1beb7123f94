//! Largest eigenfrequency.

use super::Model;

impl<const D: usize> Model<D> {
    /// Largest eigenfrequency ω at a displacement, in rad/s: an upper estimate of the root of the largest eigenvalue of
    /// M⁻¹K, M diagonal with `mass` per node. The leapfrog is stable for steps below 2/ω.
    pub fn largest_frequency(&self, displacement: &[[f64; D]], mass: &[f64]) -> f64 {
        let _ = (displacement, mass);
        0.0
    }

    /// Bound of the same from single elements: never below [`Model::largest_frequency`], mostly little above.
    pub fn frequency_bound(&self, displacement: &[[f64; D]], mass: &[f64]) -> f64 {
        let _ = (displacement, mass);
        0.0
    }
}
