//! Bodies that nothing but contact holds, brought to where it does.

use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::motion::Motion;
use super::noise::Noise;

/// Part of the load on a motion that may be left over: Newton's method does the rest.
const LEFT_OVER: f64 = 0.1;

/// Part of the size of all bodies to which the place is found where a body is let go.
const TOUCHING: f64 = 1e-6;

/// Directions tried; one does where one motion is free.
const MOST_DIRECTIONS: usize = 30;

impl<const D: usize> Equilibrium<D> {
    /// Moves bodies without deforming them until contact balances their loads, roughly; those that are held already
    /// stay, and those that nothing but contact drives are left where they are free of it. The energy of contact and load
    /// over rigid motions is smooth, and nothing is factorised.
    pub(super) fn approach(&mut self, start: Vec<[f64; D]>, load: f64) -> Result<Vec<[f64; D]>, StaticsError> {
        let motions = self.free_motions(&start);
        if motions.is_empty() {
            return Ok(start);
        }
        if self.is_supported(&start)? {
            return Ok(start);
        }
        let mut u = start;
        let mut driven = 0.0;
        for _ in 0..MOST_DIRECTIONS {
            let slopes = self.slopes(&motions, &u, load)?;
            let size = norm(&slopes);
            driven = f64::max(driven, size);
            if size <= LEFT_OVER * driven {
                break;
            }
            let direction: Vec<f64> = slopes.iter().map(|slope| -slope / size).collect();
            u = self.march(&motions, &direction, u, load)?;
        }
        self.keep_patches(&u)?;
        // What is at rest needs nothing that holds it.
        if self.evaluate(&u, load)?.relative() <= self.settings.tolerance {
            return Ok(u);
        }
        self.unsupported(&u)?.map_or(Ok(u), Err)
    }

    /// Whether supports and contact, where it is now, hold all bodies.
    pub(super) fn is_supported(&mut self, u: &[[f64; D]]) -> Result<bool, StaticsError> {
        self.contact.release_patches();
        Ok(self.unsupported(u)?.is_none() && !(self.is_depth() && self.is_driven_on(u)?))
    }

    /// Derivative of the energy along every motion; what deforms the bodies does no work on them.
    fn slopes(&mut self, motions: &[Motion<D>], u: &[[f64; D]], load: f64) -> Result<Vec<f64>, StaticsError> {
        let balance = self.evaluate(u, load)?;
        Ok(motions.iter().map(|motion| motion.work(&balance.residual)).collect())
    }

    /// Goes along a direction to where the energy is least.
    fn march(
        &mut self,
        motions: &[Motion<D>],
        direction: &[f64],
        u: Vec<[f64; D]>,
        load: f64,
    ) -> Result<Vec<[f64; D]>, StaticsError> {
        let at = |length: f64| {
            let mut moved = u.clone();
            motions.iter().zip(direction).for_each(|(motion, part)| motion.add_to(&mut moved, length * part));
            moved
        };
        let slope_at = |this: &mut Self, length: f64| -> Result<f64, StaticsError> {
            let slopes = this.slopes(motions, &at(length), load)?;
            Ok(slopes.iter().zip(direction).map(|(slope, part)| slope * part).sum())
        };
        let size = self.size();
        // Work of rounding on all nodes together.
        let nothing = Noise::of(&self.problem.model, self.size()).force * (self.equation_count as f64).sqrt();
        let first = slope_at(self, 0.0)?;
        let (mut low, mut low_slope, mut high) = (0.0, first, 1e-6 * size);
        let mut high_slope = slope_at(self, high)?;
        while high_slope < -nothing {
            (low, low_slope, high) = (high, high_slope, 2.0 * high);
            if high > 10.0 * size {
                return Err(self.driven_off(motions, direction));
            }
            high_slope = slope_at(self, high)?;
        }
        if high_slope <= nothing {
            // Nothing pushes any more: to where that begins.
            while high - low > TOUCHING * size {
                let middle = 0.5 * (low + high);
                let is_free = slope_at(self, middle)? >= -nothing;
                *if is_free { &mut high } else { &mut low } = middle;
            }
            return Ok(at(high));
        }
        // Regula falsi, halving the weight of an end that stays (Illinois).
        for _ in 0..60 {
            let middle = (low * high_slope - high * low_slope) / (high_slope - low_slope);
            let slope = slope_at(self, middle)?;
            if slope.abs() <= 0.5 * LEFT_OVER * first.abs() {
                return Ok(at(middle));
            }
            if slope < 0.0 {
                (low, low_slope, high_slope) = (middle, slope, 0.5 * high_slope);
            } else {
                (high, high_slope, low_slope) = (middle, slope, 0.5 * low_slope);
            }
        }
        Ok(at(high))
    }

    fn driven_off(&self, motions: &[Motion<D>], direction: &[f64]) -> StaticsError {
        let most = (0..motions.len()).max_by(|p, q| direction[*p].abs().total_cmp(&direction[*q].abs())).unwrap_or(0);
        let motion = &motions[most];
        let body = self.problem.model.parts()[motion.part].name.clone();
        StaticsError::Separated { body, motion: motion.name.clone() }
    }
}

fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}
