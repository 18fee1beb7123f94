//! The part of a step during which a facet bears: its slip is counted from its touch.
//!
//! With the area A in contact, the depth D = ∫ g dA below the other surface and the normal approach a of a step, all of one
//! facet, dD = A da. So what a step adds to D, by its approach, is the mean of A on the way, which lies between the areas at
//! both ends. Springs that touch in the middle of a step are stretched by what is left of it: together by that mean times
//! the slip of the step. What was carried stays on the springs that carried it: those that join, however they came, are not
//! stretched.
//!
//! Loads that grow in proportion, from nothing, meet with an equal part of the slip and of the approach everywhere, and what
//! is counted here is then exact whatever the step.

use super::carriers::SliderName;
use std::collections::BTreeMap;

/// How a facet bears.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bearing {
    /// Area in contact, in parts of the facet's measure.
    pub(crate) area: f64,
    /// Integral of the depth over it, in the same parts.
    pub(crate) depth: f64,
    /// The facet's measure.
    pub(crate) whole: f64,
}

impl Bearing {
    /// How it bears with the same pressure by what is `stiffer` by a factor, and by how much less deep that is.
    pub(crate) fn by_stiffer(self, stiffer: f64) -> (Self, f64) {
        let depth = self.depth / stiffer;
        let less = if self.area > 0.0 { (self.depth - depth) / self.area } else { 0.0 };
        (Self { depth, ..self }, less)
    }
}

/// All facets that bear, by their pair, their side and their number in the surface.
pub(crate) type FacetBearings = BTreeMap<SliderName, Bearing>;

/// Part of a facet that counts as nothing: the law `fiber` measures a contact that turns as a whole to some 1e-7.
const MEASURED: f64 = 1e-5;

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
        // Area that approach brings lies no deeper than it came: the less it is beside the depth, the less can be new. What
        // grows otherwise, as facets stretch or slide on to others, slips by all of the step.
        let new = (now.area - before.area).min(now.area * (approach * now.area / now.depth));
        // What joins is not stretched, however it came; but for what a law measures otherwise as bodies turn, since areas that go up and
        // down would wear the traction out.
        let grown = now.area - before.area;
        if new > 0.0 {
            let old = now.area - new;
            let mean = (now.depth - before.depth) / approach;
            let counted = mean.clamp(old, now.area) / now.area;
            let by_approach = if old < mean && mean < now.area { (1.0 - counted) / approach } else { 0.0 };
            let carried = if grown > new + MEASURED { before.area / now.area } else { old / now.area };
            Self { carried, counted, by_approach }
        } else if grown > MEASURED {
            Self { carried: before.area / now.area, ..Self::WHOLE }
        } else {
            Self::WHOLE
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bearing(area: f64, depth: f64) -> Bearing {
        Bearing { area, depth, whole: 1.0 }
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
        // Another body slides on to it: all of its slip counts, and what it brings is not stretched.
        let carried = before.area / 0.6;
        assert_eq!(Touch::new(before, bearing(0.6, 0.06), 0.0), Touch { carried, ..Touch::WHOLE });
    }

    #[test]
    fn nothing_jumps() {
        let before = bearing(0.3, 0.2);
        let at = |angle: f64| {
            let (depth, approach) = (1e-3 * angle.cos(), 1e-3 * angle.sin());
            Touch::new(before, bearing(0.8, 0.2 + depth), approach)
        };
        // The mean is the cotangent, 0.8 at most: it changes by 1 + 0.8² of the angle, here in parts of 0.8.
        let count = 100_000;
        let most = 1.1 * std::f64::consts::TAU / f64::from(count) * 1.64 / 0.8;
        let mut last = at(0.0);
        for step in 1..=count {
            let next = at(std::f64::consts::TAU * f64::from(step) / f64::from(count));
            assert!((next.counted - last.counted).abs() < most && (next.carried - last.carried).abs() < most, "{step}");
            assert!((0.0..=1.0).contains(&next.counted) && (0.0..=1.0).contains(&next.carried));
            last = next;
        }
    }
}
