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

impl<const D: usize> SlipFacet<D> {
    /// Energy taken out, by the area in contact now; never negative. The traction acts for the whole step, though of it only the part φ
    /// counts: what slides does so at the limit for all of it.
    ///
    /// Frozen, the traction is the gradient of a potential, (stored + dissipated)/φ; what of it is not stored.
    pub(crate) fn dissipated(&self, traction: &Traction<D>) -> f64 {
        let Stick::Spring(stiffness) = self.slider.stick else { return traction.dissipated };
        let Traction { stored, dissipated, .. } = *traction;
        let Before { slip, part, area, .. } = self.before;
        let carried = 0.5 * stiffness * slip.norm_squared();
        if self.is_frozen {
            let lost = carried * (area - part * part).max(0.0);
            let by_part = if self.counted > 0.0 { (stored + dissipated) / self.counted - stored } else { dissipated };
            return lost + by_part;
        }
        let kept = carried * part * part;
        let lost = if area > 1.0 {
            0.5 * stiffness * (area - 1.0) * slip.dot(&traction.elastic).max(0.0)
        } else {
            carried * area - kept
        };
        let slid = dissipated * self.mean_limit(traction, stiffness);
        // Area that touches within the step is pulled by a part of its slip only.
        let grown = |counted: f64| slid / counted + part * (1.0 / counted - 1.0) * (stored - kept);
        (lost + if self.counted > 0.0 { grown(self.counted) } else { slid }).max(0.0)
    }

    /// How far it slid, by the mean of the pressure meanwhile over that at the end: as the limit, where that falls by nothing else.
    pub(super) fn slid_by_pressure(&self, traction: &Traction<D>) -> f64 {
        let slid = (self.trial - traction.elastic).norm();
        match self.slider.stick {
            Stick::Spring(stiffness) if self.weakening_slip == 0.0 => slid * self.mean_limit(traction, stiffness),
            _ => slid,
        }
    }

    /// Mean of the limit while the facet slides, by that at the end: until it is reached the facet sticks, and it changes evenly. 1 where it
    /// is not known what the limit was.
    fn mean_limit(&self, traction: &Traction<D>, stiffness: f64) -> f64 {
        let Before { slip, part, area, limit, .. } = self.before;
        let along = self.trial - traction.elastic;
        let slid = along.norm();
        // In the direction of the slip.
        let by_direction = self.part_of_limit(traction);
        let at_end = self.slider.limit * by_direction;
        let Some(limit) = limit.filter(|_| slid > 0.0 && at_end > 0.0).map(|limit| limit * by_direction) else {
            return 1.0;
        };
        let carried = slip.dot(&along) / slid;
        let stuck = (limit / (stiffness * area.max(1.0)) - part * carried).max(0.0);
        // With a coefficient that falls it slid by more than now.
        let limit = limit.max(stiffness * area * carried);
        1.0 - 0.5 * (1.0 - limit / at_end) * slid / (slid + stuck)
    }
}
