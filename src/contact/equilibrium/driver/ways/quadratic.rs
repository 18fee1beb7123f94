//! A convex piecewise quadratic energy of few unknowns, and where it is least.

use nalgebra::{DMatrix, DVector};

/// Iterations, at most.
const MOST: usize = 60;

/// Part of what the slope promises that a step must gain.
const GAIN: f64 = 1e-4;

/// −b·q + ½ q·H q + ½ Σ w min(0, g + J q)².
pub(crate) struct Quadratic {
    pub(crate) load: DVector<f64>,
    pub(crate) stiffness: DMatrix<f64>,
    pub(crate) gaps: DVector<f64>,
    pub(crate) slopes: DMatrix<f64>,
    pub(crate) weights: DVector<f64>,
}

impl Quadratic {
    fn sunk(&self, q: &DVector<f64>) -> DVector<f64> {
        (&self.gaps + &self.slopes * q).map(|gap| gap.min(0.0))
    }

    fn value(&self, q: &DVector<f64>) -> f64 {
        let sunk = self.sunk(q);
        0.5 * q.dot(&(&self.stiffness * q)) - self.load.dot(q) + 0.5 * sunk.component_mul(&self.weights).dot(&sunk)
    }

    /// Where it is least while all unknowns but some stay zero.
    pub(crate) fn least_along(&self, some: &[usize]) -> DVector<f64> {
        let part = Self {
            load: self.load.select_rows(some),
            stiffness: self.stiffness.select_rows(some).select_columns(some),
            gaps: self.gaps.clone(),
            slopes: self.slopes.select_columns(some),
            weights: self.weights.clone(),
        };
        let (least, mut all) = (part.least(), DVector::zeros(self.load.len()));
        some.iter().enumerate().for_each(|(place, &k)| all[k] = least[place]);
        all
    }

    /// Where it is least, by Newton's method with Armijo's rule.
    fn least(&self) -> DVector<f64> {
        let mut q = DVector::zeros(self.load.len());
        let mut value = self.value(&q);
        let mut first = None;
        for _ in 0..MOST {
            let sunk = self.sunk(&q);
            let pushed = self.slopes.transpose() * sunk.component_mul(&self.weights);
            let gradient = &self.stiffness * &q - &self.load + pushed;
            if gradient.norm() <= 1e-10 * *first.get_or_insert(gradient.norm()) {
                break;
            }
            let mut weighted = self.slopes.clone();
            for (row, mut entries) in weighted.row_iter_mut().enumerate() {
                entries *= if sunk[row] < 0.0 { self.weights[row] } else { 0.0 };
            }
            let hessian = &self.stiffness + self.slopes.transpose() * weighted;
            let Some(step) = hessian.lu().solve(&-&gradient) else { break };
            let (slope, mut length) = (gradient.dot(&step), 1.0);
            while self.value(&(&q + length * &step)) > value + GAIN * length * slope && length > 1e-6 {
                length *= 0.5;
            }
            q += length * step;
            value = self.value(&q);
        }
        q
    }
}
