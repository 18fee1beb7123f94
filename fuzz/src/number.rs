//! Numbers as hosts have them: mostly ordinary, often equal, sometimes none at all.

use arbitrary::{Arbitrary, Result, Unstructured};

/// An `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number(pub f64);

/// Far from the ordinary.
const ODD: [f64; 12] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN_POSITIVE,
    -0.0,
    1e-300,
    1e300,
    -1e150,
    1e-9,
    1e16,
    5e-324,
];

impl<'a> Arbitrary<'a> for Number {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        Ok(Self(match bytes.arbitrary::<u8>()? {
            // On a grid of sixteenths, where faces coincide.
            kind @ 0..=159 => f64::from(i16::from(kind) - 80) / 32.0,
            160..=239 => f64::from(bytes.arbitrary::<i32>()?) / f64::from(i32::MAX),
            240..=251 => ODD[bytes.arbitrary::<u8>()? as usize % ODD.len()],
            _ => bytes.arbitrary()?,
        }))
    }
}

impl Number {
    /// Whether a body of this size can be filled with lines in a moment.
    pub fn is_ordinary(&self) -> bool {
        self.0.abs() <= 4.0
    }
}
