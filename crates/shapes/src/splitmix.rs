//! Random numbers that are the same everywhere.

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::{Rng, SeedableRng};

/// SplitMix64 of rand's family. The conversions to `f64` are our own: distributions of a library may change their values with
/// a release, and every mesh with them.
#[derive(Clone, Debug)]
pub struct Splitmix(SplitMix64);

impl Splitmix {
    /// Stream of the seed.
    pub fn new(seed: u64) -> Self {
        Self(SplitMix64::from_seed(seed.to_le_bytes()))
    }

    /// Next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// Uniform in `[0, 1)`.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in `[low, high)`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Standard normal, by Box and Muller.
    pub fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.unit()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.unit()).cos()
    }
}

#[cfg(test)]
mod tests {
    use super::Splitmix;

    /// Published first output of seed 1234567.
    #[test]
    fn first_bits_of_a_seed() {
        assert_eq!(Splitmix::new(1234567).bits(), 6457827717110365317);
    }
}
