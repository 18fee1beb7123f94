//! Numbers along the side of a picture.

use crate::number::{superscript, trimmed};
use std::ops::Range;

/// An axis.
pub struct Axis {
    /// What is written along it.
    pub label: String,
    log: bool,
}

impl Axis {
    /// Linear.
    pub fn linear(label: impl Into<String>) -> Self {
        Self { label: label.into(), log: false }
    }

    /// Logarithmic; every number on it must be positive.
    pub fn log(label: impl Into<String>) -> Self {
        Self { label: label.into(), log: true }
    }

    /// Where a number lies along the axis: for a logarithmic one, its power of ten.
    pub fn place(&self, x: f64) -> f64 {
        if self.log { x.max(f64::MIN_POSITIVE).log10() } else { x }
    }

    /// Range around all places, with a margin of a twentieth.
    pub fn range(&self, places: impl Iterator<Item = f64>) -> Range<f64> {
        let finite = places.filter(|x| x.is_finite());
        let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        // Nothing to show: a picture without a curve is a picture all the same.
        let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
        // A curve that is constant gets a range as wide as its number, not one of rounding errors.
        let width = (high - low).max(0.02 * high.abs()).max(0.02);
        low - 0.05 * width..high + 0.05 * width
    }

    /// What is written at a place: on a logarithmic axis the decades only.
    pub fn tick(&self, place: f64) -> String {
        if !self.log {
            // Ticks are multiples of a round step; one that should be zero may miss it by rounding.
            return trimmed(if place.abs() < 5e-5 { 0.0 } else { place }, 4).replace('-', "−");
        }
        if (place - place.round()).abs() > 1e-6 {
            return String::new();
        }
        format!("10{}", superscript(&format!("{place:.0}")))
    }

    /// How many labels to ask for; on a logarithmic axis one per decade.
    pub fn tick_count(&self, range: &Range<f64>) -> usize {
        if self.log { (range.end - range.start) as usize + 1 } else { 7 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_read_well() {
        let (linear, log) = (Axis::linear("x"), Axis::log("x"));
        assert_eq!([0.25, -0.5, -1e-17, 3.0].map(|x| linear.tick(x)), ["0.25", "−0.5", "0", "3"]);
        assert_eq!([-12.0, 0.0, 5.0, 0.5].map(|x| log.tick(x)), ["10⁻¹²", "10⁰", "10⁵", ""]);
        assert_eq!(log.place(1e-3), -3.0);
        for axis in [linear, log] {
            for nothing in [&[][..], &[f64::NAN], &[f64::INFINITY, f64::NEG_INFINITY]] {
                let range = axis.range(nothing.iter().copied());
                assert!(range.start < range.end && (range.end - range.start).is_finite(), "{range:?}");
            }
        }
    }
}
