//! Where along a step the load turns.

/// Part of the bracket that stays on either side of the next trial.
const MARGIN: f64 = 0.1;

/// Between a part of a step along which the load still drives on, and one at which it drives back.
pub(super) struct Bracket {
    on: (f64, f64),
    back: Option<(f64, f64)>,
}

impl Bracket {
    /// With the load where the step begins.
    pub(super) fn new(driving: f64) -> Self {
        Self { on: (0.0, driving), back: None }
    }

    /// What the load is at a part of the step.
    pub(super) fn add(&mut self, part: f64, load: f64) {
        if load > 0.0 {
            self.on = (part, load);
        } else {
            self.back = Some((part, load));
        }
    }

    /// The part to try next, by the secant; none as long as it has turned nowhere.
    pub(super) fn next(&self) -> Option<f64> {
        let (on, back) = (self.on, self.back?);
        let (width, secant) = (back.0 - on.0, on.0 + (back.0 - on.0) * on.1 / (on.1 - back.1));
        Some(secant.clamp(on.0 + MARGIN * width, back.0 - MARGIN * width))
    }
}
