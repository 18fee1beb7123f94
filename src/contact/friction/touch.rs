//! The part of a step during which a facet bears: its slip is counted from its touch.
//!
//! With the area A in contact, the depth D = ∫ g dA below the other surface and the normal approach a of a step, all of one
//! facet, dD = A da. So what a step adds to D, by its approach, is the mean of A on the way, which lies between the areas at
//! both ends. Springs that touch in the middle of a step are stretched by what is left of it: together by that mean times
//! the slip of the step. What was carried stays on the springs that carried it, so that the new ones share its force.
//!
//! Loads that grow in proportion, from nothing, meet with an equal part of the slip and of the approach everywhere, and what
//! is counted here is then exact whatever the step.

use crate::overlap::Partner;
use std::collections::BTreeMap;

/// How a facet bears.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bearing {
    /// Area in contact, in parts of the facet's measure.
    pub(crate) area: f64,
    /// Integral of the depth over it, in the same parts.
    pub(crate) depth: f64,
}

/// All facets that bear, by their pair, their side and their number in the surface.
pub(crate) type Bearings = BTreeMap<([Partner; 2], bool, usize), Bearing>;

/// What counts of a step's slip, and of the slip that was carried into it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Touch {
    /// Part of the carried slip that stays, as a mean over the area in contact now.
    pub(crate) carried: f64,
    /// Part of the step during which the facet bears, as such a mean.
    pub(crate) counted: f64,
    /// What `counted` changes by with the approach.
    pub(crate) by_approach: f64,
}

impl Touch {
    /// All of the step.
    pub(crate) const WHOLE: Self = Self { carried: 1.0, counted: 1.0, by_approach: 0.0 };

    /// Of a facet that came nearer by `approach`, positive, as a mean over its area in contact now.
    pub(crate) fn new(before: Bearing, now: Bearing, approach: f64) -> Self {
        let new_area = now.area - before.area;
        if new_area <= 0.0 || approach.is_nan() {
            return Self::WHOLE;
        }
        // Depth beyond what the old area gained, and what the whole area would have gained more.
        let (gained, missing) =
            (now.depth - before.depth - before.area * approach, now.area * approach - (now.depth - before.depth));
        // Neither is negative where area comes by approach. Where it comes by other ways, as facets slide on to others or
        // move away, the larger of two signs decides, so that nothing jumps.
        let (for_it, against) = (gained.max(-missing).max(0.0), missing.max(-gained).max(0.0));
        let part = if for_it > 0.0 {
            for_it / (for_it + against)
        } else if against > 0.0 {
            0.0
        } else {
            1.0
        };
        // More depth than approach can bring: that area was not touched anew, and carries as the old one does.
        let excess = (-missing).max(0.0);
        let old = if excess > 0.0 { (excess / gained.abs()).min(1.0) } else { 0.0 };
        let of_new = |part: f64| (before.area + part * new_area) / now.area;
        let counted = of_new(part);
        let by_approach = if gained > 0.0 && missing > 0.0 { (1.0 - counted) / approach } else { 0.0 };
        Self { carried: of_new(old), counted, by_approach }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bearing(area: f64, depth: f64) -> Bearing {
        Bearing { area, depth }
    }

    /// A flat facet that touches when three quarters of the step are over.
    #[test]
    fn counts_from_the_touch() {
        let found = Touch::new(Bearing::default(), bearing(1.0, 0.1), 0.4);
        assert!((found.counted - 0.25).abs() < 1e-15);
        let slope =
            (Touch::new(Bearing::default(), bearing(1.0, 0.1 + 1e-7), 0.4 + 1e-7).counted - found.counted) / 1e-7;
        assert!((slope - found.by_approach).abs() < 1e-5);
    }

    /// A wedge whose contact grows from 0.2 to 0.6 of the facet: the mean of that is 0.4.
    #[test]
    fn the_mean_area_of_a_wedge() {
        let of = |area: f64| bearing(area, 0.5 * area * area);
        let found = Touch::new(of(0.2), of(0.6), 0.4);
        assert!((found.counted - 0.4 / 0.6).abs() < 1e-15 && (found.carried - 0.2 / 0.6).abs() < 1e-15);
    }

    #[test]
    fn all_of_the_step_where_nothing_is_touched_anew() {
        let before = bearing(0.5, 0.05);
        assert_eq!(Touch::new(before, bearing(0.5, 0.09), 0.1), Touch::WHOLE);
        assert_eq!(Touch::new(before, bearing(0.4, 0.01), -0.1), Touch::WHOLE);
        // Another body slides on to it.
        assert_eq!(Touch::new(before, bearing(0.6, 0.06), 0.0), Touch::WHOLE);
    }

    /// Around the point at which nothing is gained and nothing approaches.
    #[test]
    fn nothing_jumps() {
        let before = bearing(0.3, 0.2);
        let at = |angle: f64| {
            let (depth, approach) = (1e-3 * angle.cos(), 1e-3 * angle.sin());
            Touch::new(before, bearing(0.8, 0.2 + depth), approach)
        };
        let count = 100_000;
        let mut last = at(0.0);
        for step in 1..=count {
            let next = at(std::f64::consts::TAU * step as f64 / count as f64);
            assert!((next.counted - last.counted).abs() < 1e-3 && (next.carried - last.carried).abs() < 1e-3, "{step}");
            assert!((0.0..=1.0).contains(&next.counted) && (0.0..=1.0).contains(&next.carried));
            last = next;
        }
    }
}
