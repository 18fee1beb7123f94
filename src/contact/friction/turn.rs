//! By what the way between two material points turns in a step.
//!
//! Of two points that meet now, and that lay apart by X when the step began, the slip is −M X. If both sides turn alike, M is that rotation,
//! and nothing slips. If one turns by θ against the other, as on a screw, the velocity at a fixed place is the same throughout, and
//!
//! ```text
//! M = Q^½ (θ/2)/sin(θ/2)    across the axis, Q the rotation: the slip is the arc r θ
//! ```
//!
//! which is the mean of both rotations, of cos(θ/2) Q^½ across the axis, times θ/sin θ.

use nalgebra::SMatrix;

/// Angle up to which a turn counts as it is, in radians: beyond half a turn nothing tells it from one the other way round.
pub(crate) const MOST: f64 = 3.0;

/// M of two sides with these deformations since the step began.
pub(super) fn turned<const D: usize>(a: &SMatrix<f64, D, D>, b: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
    let mean = (a + b) * 0.5;
    let against = b * a.transpose();
    let skew = (against - against.transpose()) * 0.5;
    let square = 0.5 * skew.norm_squared();
    if square == 0.0 {
        return mean;
    }
    let across = skew * skew * (-1.0 / square);
    let angle = (2.0 * square.sqrt()).atan2((across * against).trace()).min(MOST);
    let factor = angle / angle.sin();
    mean + across * mean * (factor - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;

    /// exp of a skew matrix, by many small steps.
    fn rotation<const D: usize>(skew: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
        let mut turn = SMatrix::identity() + skew / 1048576.0 + skew * skew * (0.5 / 1048576.0f64.powi(2));
        (0..20).for_each(|_| turn *= turn);
        turn
    }

    /// A side that goes on a screw slips by the velocity at the place, of a unit of time; and turned as a whole just so.
    fn on_a_screw<const D: usize>(axis: SMatrix<f64, D, D>) {
        let skew = (axis - axis.transpose()) * 0.5;
        let skew = skew / (0.5 * skew.norm_squared()).sqrt();
        let place = Vector::<D>::from_fn(|i, _| 2.0 - 0.7 * i as f64);
        let along = Vector::<D>::from_fn(|i, _| 0.3 + 0.2 * i as f64);
        let whole = rotation(&((axis.transpose() - axis) * 0.9));
        for angle in [1e-3, 0.3, 1.0, 2.0, 2.9] {
            let spin = skew * angle;
            let velocity = spin * place + along;
            // Where the point was that is at the place now: back along the screw, in small steps of the midpoint rule.
            let (mut then, count) = (place, 100_000);
            for _ in 0..count {
                let middle = then - (spin * then + along) / (2.0 * f64::from(count));
                then -= (spin * middle + along) / f64::from(count);
            }
            let found = turned(&SMatrix::identity(), &rotation(&spin)) * (place - then);
            // The midpoint rule in 1e5 steps, and the exponential.
            assert!((found - velocity).norm() < 1e-8, "{angle}: {found} {velocity}");
            let found = turned(&whole, &(whole * rotation(&spin))) * (place - then);
            assert!((found - whole * velocity).norm() < 1e-8, "{angle}: {found}");
            let swapped = turned(&(whole * rotation(&spin)), &whole) * (place - then);
            assert!((found - swapped).norm() < 1e-9, "{angle}");
        }
        let alike = turned(&(whole * 1.1), &(whole * 1.1));
        assert!((alike - whole * 1.1).norm() < 1e-15);
    }

    #[test]
    fn the_slip_of_a_turn_is_its_arc() {
        on_a_screw(SMatrix::<f64, 2, 2>::new(0.0, -1.0, 0.0, 0.0));
        on_a_screw(SMatrix::<f64, 3, 3>::new(0.0, -1.0, 0.4, 0.0, 0.0, 0.3, 0.0, 0.0, 0.0));
    }
}
