//! Options of the context and of pairs.

use crate::number::Number;
use arbitrary::Arbitrary;

/// Values of options; small numbers mostly, so that they mean something.
#[derive(Arbitrary, Clone, Debug)]
pub struct Options {
    pub stiffness: Number,
    pub exponent: Option<Number>,
    pub smoothing_length: Option<Number>,
    pub friction: Option<Number>,
    pub friction_stiffness: Option<Number>,
    pub cohesion: Option<Number>,
    pub spacing: Option<Number>,
    pub fiber_length: Option<Number>,
    pub fiber_count: Option<u8>,
    pub seed: u64,
    /// Law, estimator, pattern, weights, momentum correction, self-contact, check of the cells: by twos of bits, 3 being no value; then
    /// a limit of shear, or axisymmetry.
    pub choices: u16,
    pub index_base: bool,
    /// Two threads.
    pub is_threaded: bool,
    /// A struct that no `_init` function has seen.
    pub is_raw: u8,
}

/// Options of a pair.
#[derive(Arbitrary, Clone, Debug)]
pub struct PairOptions {
    /// Kind and index of both sides, in one number each.
    pub sides: [u8; 2],
    /// One less is the law.
    pub law: u8,
    pub stiffness: Number,
    pub exponent: Option<Number>,
    pub smoothing_length: Option<Number>,
    pub excluded: u8,
    pub gap_offset: Option<Number>,
}
