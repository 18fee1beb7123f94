//! What a step has shown of the tangent that Newton's method has not.

use crate::contact::equilibrium::driver::asking::unknowns::{dot, moved};

/// Part of a step that the residual must have followed.
const SEEN: f64 = 0.05;

/// Broyden's correction of rank one (1965), of the tangent of now by the last step. The tangent of friction leaves terms out, by which steps
/// go too far, or not far enough, along one direction mostly: where bodies jam it can be by more than the step itself.
#[derive(Default)]
pub(crate) struct Secant {
    /// Newton's step, and the one that was taken.
    last: Option<(Vec<f64>, Vec<f64>)>,
    newton: Vec<f64>,
}

impl Secant {
    /// The step with the correction, where the last one was whole and the problem is the same.
    pub(crate) fn corrected(&mut self, newton: Vec<f64>, is_wanted: bool) -> Vec<f64> {
        self.newton.clone_from(&newton);
        let Some((before, taken)) = self.last.take().filter(|_| is_wanted) else { return newton };
        // By the tangent of now, what the residual has changed by.
        let followed = moved(&before, -1.0, &newton);
        let size = dot(&taken, &followed);
        if size.abs() < SEEN * dot(&taken, &taken) {
            return newton;
        }
        moved(&newton, dot(&taken, &newton) / size, &moved(&taken, -1.0, &followed))
    }

    /// A step was taken, this part of it.
    pub(crate) fn taken(&mut self, part: f64, step: Vec<f64>) {
        self.last = (part == 1.0).then(|| (std::mem::take(&mut self.newton), step));
    }
}
