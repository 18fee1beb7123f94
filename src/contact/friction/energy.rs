//! What a facet has dissipated since the step began.
//!
//! With the area A in contact and the elastic slip e the work of a step is that of the mean force at both ends, and what of it is neither
//! stored nor taken by the slider is lost with area:
//!
//! ```text
//! A shrinks:  ½ k_T (A₀ − A) e₀·e      its stretch leaves with it
//! A grows:    ½ k_T A₀ e₀² (1 − A₀/A)  what joins is not stretched: the same force by more area
//! ```
//!
//! so that stored and dissipated energy together are the work done, up to terms of second order in the step. What slides does so at the
//! mean of the limit over the part of the step in which it slides.

use super::slip_facets::{Before, SlipFacet};
use super::traction::{Stick, Traction};

/// Whether a coefficient that falls counts, beside the pressure.
#[derive(Clone, Copy, PartialEq)]
enum Falls {
    Also,
    Not,
}

impl<const D: usize> SlipFacet<D> {
    /// Energy taken out, by the area in contact now; never negative. The traction acts for the whole step, though of it only the part φ
    /// counts: what slides does so at the limit for all of it.
    ///
    /// Frozen, the traction is the gradient of a potential, (stored + dissipated)/φ; what of it is not stored.
    pub(crate) fn dissipated(&self, traction: &Traction<D>) -> f64 {
        let Stick::Spring(stiffness) = self.slider.stick else { return traction.dissipated };
        let Traction { stored, dissipated, .. } = *traction;
        if self.is_frozen {
            let Before { slip, part, area, .. } = self.before;
            let lost = 0.5 * stiffness * slip.norm_squared() * (area - part * part).max(0.0);
            let by_part = if self.counted > 0.0 { (stored + dissipated) / self.counted - stored } else { dissipated };
            return lost + by_part;
        }
        self.taken_out(traction, stiffness, self.mean_limit(traction, stiffness, Falls::Also))
    }

    /// How far it slid, by what was taken out meanwhile over the limit of now: times the pressure of now, ∫ p |ds| with all that comes into
    /// contact and leaves it.
    pub(super) fn way(&self, traction: &Traction<D>) -> f64 {
        let Stick::Spring(stiffness) = self.slider.stick else { return self.trial.norm() };
        if !traction.slides {
            return 0.0;
        }
        let limit = self.slider.limit * self.part_of_limit(traction);
        // As its coefficient falls a facet slides against more than its pressure by the coefficient of now.
        let falls = if self.weakening_slip > 0.0 { Falls::Not } else { Falls::Also };
        let work = self.taken_out(traction, stiffness, self.mean_limit(traction, stiffness, falls));
        if limit > 0.0 { work / limit } else { 0.0 }
    }

    fn taken_out(&self, traction: &Traction<D>, stiffness: f64, mean_limit: f64) -> f64 {
        let Traction { stored, dissipated, .. } = *traction;
        let Before { slip, part, area, .. } = self.before;
        let carried = 0.5 * stiffness * slip.norm_squared();
        let kept = carried * part * part;
        let lost = if area > 1.0 {
            0.5 * stiffness * (area - 1.0) * slip.dot(&traction.elastic).max(0.0)
        } else {
            carried * area - kept
        };
        let slid = dissipated * mean_limit;
        // Area that touches within the step is pulled by a part of its slip only.
        let grown = |counted: f64| slid / counted + part * (1.0 / counted - 1.0) * (stored - kept);
        (lost + if self.counted > 0.0 { grown(self.counted) } else { slid }).max(0.0)
    }

    /// Mean of the limit while the facet slides, by that at the end: until it is reached the facet sticks, and it changes evenly. 1 where it
    /// is not known what the limit was.
    fn mean_limit(&self, traction: &Traction<D>, stiffness: f64, falls: Falls) -> f64 {
        let Before { slip, part, area, limit, pulled, .. } = self.before;
        let along = self.trial - traction.elastic;
        let slid = along.norm();
        // In the direction of the slip.
        let by_direction = self.part_of_limit(traction);
        let at_end = self.slider.limit * by_direction;
        let Some(limit) = limit.filter(|_| slid > 0.0 && at_end > 0.0).map(|limit| limit * by_direction) else {
            return 1.0;
        };
        let carried = pulled * slip.dot(&along) / slid;
        let stuck = (limit / (stiffness * area.max(1.0)) - part * carried).max(0.0);
        // With a coefficient that falls it slid by more than now, and on a surface that was worn off before a load was back.
        let pull = stiffness * area * carried;
        let pull = if falls == Falls::Not { pull.min(at_end) } else { pull };
        let limit = limit.max(pull);
        1.0 - 0.5 * (1.0 - limit / at_end) * slid / (slid + stuck)
    }
}
