//! The force at which facets slid where they bore otherwise than now.

use super::touch::Bearing;
use std::iter::Sum;

/// How facets bear, and the force at which they slide.
#[derive(Clone, Copy, Default)]
pub(super) struct Bore {
    /// Area in contact.
    pub(super) area: f64,
    /// Integral of the depth over it.
    pub(super) depth: f64,
    /// Part of the force that is by pressure, and the rest.
    pub(super) pressed: f64,
    pub(super) cohesion: f64,
}

impl Sum for Bore {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), |sum, one| Self {
            area: sum.area + one.area,
            depth: sum.depth + one.depth,
            pressed: sum.pressed + one.pressed,
            cohesion: sum.cohesion + one.cohesion,
        })
    }
}

impl Bore {
    /// Force at which a facet slid that bore so before, by pressure that grows with the depth.
    pub(super) fn limit_before(&self, before: &Bearing) -> f64 {
        let by_area = before.area * before.whole / self.area;
        let by_depth = if self.depth > 0.0 { few(before.depth * before.whole / self.depth) } else { by_area };
        // What never slides has no limit, also where it did not bear.
        let of_area = if by_area > 0.0 { self.cohesion * by_area } else { 0.0 };
        self.pressed * by_depth + of_area
    }
}

/// Of a correction few digits matter, and the last ones of a depth are those of how it was measured.
fn few(x: f64) -> f64 {
    f64::from(x as f32)
}
