//! The three ways an overlap is measured here.

use crate::chart::{Mark, Series, Sign};
use fmc_contact::{Estimator, FiberOptions, FiberPattern, Resolution};

/// A way to measure an overlap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Short segments of random direction: the paper's.
    Isotropic,
    /// Families of parallel lines.
    Lines,
    /// Clipping.
    Exact,
}

impl Method {
    /// All of them, in the order of the table.
    pub const ALL: [Method; 3] = [Method::Isotropic, Method::Lines, Method::Exact];

    /// Name in the table.
    pub fn name(self) -> &'static str {
        match self {
            Method::Isotropic => "isotropic",
            Method::Lines => "lines",
            Method::Exact => "exact",
        }
    }

    /// The estimator. `length` is that of an isotropic fiber.
    ///
    /// The momentum correction is off: it would turn the derivative of the turning cube into zero whatever the estimate.
    pub fn estimator(self, resolution: Resolution, seed: u64, length: f64) -> Estimator {
        let pattern = match self {
            Method::Isotropic => FiberPattern::Isotropic { length: Some(length) },
            Method::Lines => FiberPattern::Lines,
            Method::Exact => return Estimator::Exact,
        };
        Estimator::Fibers(FiberOptions {
            pattern,
            resolution,
            seed,
            momentum_correction: false,
            ..FiberOptions::default()
        })
    }

    /// Points in its colour, which tells methods apart for colour-blind readers too (Okabe and Ito), and with its sign.
    pub fn series(self, mark: Mark, points: Vec<(f64, f64)>) -> Series {
        let (color, sign) = match self {
            Method::Isotropic => ((213, 94, 0), Sign::Cross),
            Method::Lines => ((0, 114, 178), Sign::Circle),
            Method::Exact => ((0, 158, 115), Sign::Square),
        };
        Series { mark, sign, ..Series::line(self.name(), color, points) }
    }
}
