//! A motion from one pose to another.

use super::pose::Pose;
use crate::geometry::Vector;
use nalgebra::SMatrix;

/// Angle of one piece of a motion that turns, in radians: an arc and its chord differ by half a per cent of the radius.
const PIECE: f64 = 0.2;

/// Sine below which a turn is none, or half a turn: the axis is then not to be had from the difference of a rotation and its inverse.
const STRAIGHT: f64 = 1e-8;

/// The origin of the shape goes straight, and the shape turns about it at a constant rate, by half a turn at most.
pub(crate) struct Motion<const D: usize> {
    from: Pose<D>,
    to: Pose<D>,
    /// Skew matrix of the axis, a unit vector.
    axis: SMatrix<f64, D, D>,
    /// In radians.
    pub(crate) angle: f64,
}

impl<const D: usize> Motion<D> {
    pub(crate) fn new(from: Pose<D>, to: Pose<D>) -> Self {
        let [first, last] = [from, to].map(|pose| SMatrix::<f64, D, D>::from_fn(|i, j| pose.rotation[i][j]));
        let turn = last * first.transpose();
        let skew = (turn - turn.transpose()) * 0.5;
        let (sine, cosine) = ((0.5 * skew.norm_squared()).sqrt(), 0.5 * (turn.trace() - (D as f64 - 2.0)));
        let angle = sine.atan2(cosine);
        let axis = match sine > STRAIGHT {
            true => skew / sine,
            false if cosine < 0.0 => half_turn(&turn),
            false => SMatrix::zeros(),
        };
        Self { from, to, axis, angle }
    }

    /// How far the origin goes.
    pub(crate) fn length(&self) -> f64 {
        (Vector::from(self.to.position) - Vector::from(self.from.position)).norm()
    }

    /// The poses at the ends of its pieces, in which it is nearly straight.
    pub(crate) fn poses(&self) -> Vec<Pose<D>> {
        let count = 1 + (self.angle / PIECE) as usize;
        (0..=count).map(|k| self.at(k as f64 / count as f64)).collect()
    }

    /// The pose at a part of the way.
    pub(crate) fn at(&self, part: f64) -> Pose<D> {
        if part == 0.0 {
            return self.from;
        }
        if part == 1.0 {
            return self.to;
        }
        let rotation =
            turn_about(&self.axis, part * self.angle) * SMatrix::<f64, D, D>::from_fn(|i, j| self.from.rotation[i][j]);
        let between = |a: f64, b: f64| a + part * (b - a);
        Pose {
            position: std::array::from_fn(|i| between(self.from.position[i], self.to.position[i])),
            rotation: std::array::from_fn(|i| std::array::from_fn(|j| rotation[(i, j)])),
            scale: between(self.from.scale, self.to.scale),
        }
    }
}

/// The rotation by an angle about the axis that a skew matrix has, that of a unit vector.
pub(crate) fn turn_about<const D: usize>(axis: &SMatrix<f64, D, D>, angle: f64) -> SMatrix<f64, D, D> {
    let (sine, cosine) = angle.sin_cos();
    SMatrix::identity() + axis * sine + axis * axis * (1.0 - cosine)
}

/// The skew matrix of the axis of a half turn; in 2D it is counter-clockwise.
fn half_turn<const D: usize>(turn: &SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
    if D == 2 {
        return SMatrix::from_fn(|i, j| i as f64 - j as f64);
    }
    // Twice the square of the axis is what a half turn and the identity add up to.
    let square = turn + SMatrix::identity();
    let column = (0..D).max_by(|&a, &b| square[(a, a)].total_cmp(&square[(b, b)])).unwrap_or(0);
    let axis: Vector<D> = square.column(column).normalize();
    SMatrix::from_fn(|i, j| match (j + D - i) % D {
        0 => 0.0,
        1 => -axis[D - i - j],
        _ => axis[D - i - j],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A motion at two parts of its way is the one that the angle and the axis say.
    #[test]
    fn the_way_between_two_poses_turns_at_a_constant_rate() {
        for angle in [0.0, 1e-5, 0.7, 2.0, -3.0, std::f64::consts::PI] {
            for axis in [[0.0, 0.0, 1.0], [0.3, -0.5, 0.2], [-1.0, 0.1, 0.0]] {
                let from = Pose::at([1.0, 2.0, 3.0]).turned_about([0.2, 1.0, -0.4], 0.4);
                let end = |part: f64| {
                    let first = SMatrix::<f64, 3, 3>::from_fn(|i, j| from.rotation[i][j]);
                    let turn = Pose::<3>::default().turned_about(axis, part * angle);
                    SMatrix::<f64, 3, 3>::from_fn(|i, j| turn.rotation[i][j]) * first
                };
                let to = Pose {
                    position: [3.0, 2.0, 1.0],
                    rotation: std::array::from_fn(|i| std::array::from_fn(|j| end(1.0)[(i, j)])),
                    scale: 2.0,
                };
                let motion = Motion::new(from, to);
                assert!((motion.angle - angle.abs()).abs() < 1e-9, "{angle}: {}", motion.angle);
                assert!((motion.length() - 8f64.sqrt()).abs() < 1e-14);
                for part in [0.0, 0.25, 1.0] {
                    let found = motion.at(part);
                    let rotation = SMatrix::<f64, 3, 3>::from_fn(|i, j| found.rotation[i][j]);
                    // A half turn may be about the axis or against it: both are as short.
                    let other = angle == std::f64::consts::PI && (rotation - end(-part)).amax() < 1e-7;
                    assert!(other || (rotation - end(part)).amax() < 1e-7, "{angle} {axis:?} {part}");
                    assert_eq!(found.position, [1.0 + 2.0 * part, 2.0, 3.0 - 2.0 * part]);
                    assert_eq!(found.scale, 1.0 + part);
                }
            }
            let plane = Motion::new(Pose::<2>::default(), Pose::<2>::default().turned(angle)).at(0.5);
            let expected = Pose::<2>::default().turned(0.5 * angle);
            let difference = |i: usize, j: usize| (plane.rotation[i][j] - expected.rotation[i][j]).abs();
            assert!((0..2).all(|i| (0..2).all(|j| difference(i, j) < 1e-7)), "{angle}");
        }
    }
}
