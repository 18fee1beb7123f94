//! The way of all points and obstacles from one state to another.

use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::partners::Poses;
use crate::geometry::{Motion, Pose, Vector, turn_about};
use nalgebra::{DMatrix, SMatrix};

/// A way: points go straight, obstacles as rigid ones.
pub(crate) struct Path<const D: usize> {
    from: Vec<[f64; D]>,
    way: Vec<Vector<D>>,
    turning: Vec<Turning<D>>,
    /// `None` for an obstacle that stays where it is, or is not there.
    obstacles: Vec<Option<Motion<D>>>,
    poses: Poses<D>,
}

/// A body that turns, by the rotation that its small displacements are the beginning of: they may go on until it is not small.
struct Turning<const D: usize> {
    rows: Vec<usize>,
    middle: Vector<D>,
    along: Vector<D>,
    skew: SMatrix<f64, D, D>,
}

impl<const D: usize> Path<D> {
    /// From `from` by `way`, with obstacles from `before` to `now`.
    pub(crate) fn straight(from: &[[f64; D]], way: Vec<Vector<D>>, (before, now): (&Poses<D>, &Poses<D>)) -> Self {
        let of_obstacle = |(obstacle, now)| {
            let now: &Option<Pose<D>> = now;
            let both = before.get(obstacle).copied().flatten().zip(*now);
            both.filter(|(before, now)| before != now).map(|(before, now)| Motion::new(before, now))
        };
        let obstacles = now.iter().enumerate().map(of_obstacle).collect();
        Self { from: from.to_vec(), way, turning: Vec::new(), obstacles, poses: now.clone() }
    }

    /// The same with bodies that turn as rigid ones, and deform in proportion.
    pub(crate) fn turning(self, assembly: &Assembly<D>) -> Self {
        let turning = assembly.rows.iter().filter(|rows| !rows.is_empty());
        let turning = turning.map(|rows| Turning::new(rows, &self.from, &self.way)).collect();
        Self { turning, ..self }
    }

    /// The longest way of a point or of the origin of an obstacle.
    pub(crate) fn longest(&self) -> f64 {
        let of_points = self.way.iter().map(|way| way.norm());
        of_points.chain(self.obstacles.iter().flatten().map(Motion::length)).fold(0.0, f64::max)
    }

    /// Points and obstacles at a part of the way.
    pub(crate) fn at(&self, part: f64) -> (Vec<[f64; D]>, Poses<D>) {
        let line = |(from, way): (&[f64; D], &Vector<D>)| (Vector::from(*from) + way * part).into();
        let mut coords: Vec<[f64; D]> = self.from.iter().zip(&self.way).map(line).collect();
        self.turning.iter().for_each(|body| body.put(&self.from, &self.way, part, &mut coords));
        let pose = |(motion, pose): (&Option<Motion<D>>, &Option<Pose<D>>)| match motion {
            Some(motion) => Some(motion.at(part)),
            None => *pose,
        };
        (coords, self.obstacles.iter().zip(&self.poses).map(pose).collect())
    }
}

impl<const D: usize> Turning<D> {
    /// By the least sum of squares.
    fn new(rows: &[usize], from: &[[f64; D]], way: &[Vector<D>]) -> Self {
        let count = rows.len() as f64;
        let middle = rows.iter().map(|&row| Vector::from(from[row])).sum::<Vector<D>>() / count;
        let along = rows.iter().map(|&row| way[row]).sum::<Vector<D>>() / count;
        let (mut spread, mut moved) = (DMatrix::<f64>::zeros(D, D), DMatrix::<f64>::zeros(D, D));
        for &row in rows {
            let (x, d) = (Vector::from(from[row]) - middle, way[row] - along);
            spread += DMatrix::from_fn(D, D, |i, j| x[i] * x[j]);
            moved += DMatrix::from_fn(D, D, |i, j| d[i] * x[j]);
        }
        // W C + C W = M − Mᵀ, entry by entry along the axes of C.
        let axes = spread.symmetric_eigen();
        let mut skew = axes.eigenvectors.transpose() * (&moved - moved.transpose()) * &axes.eigenvectors;
        for i in 0..D {
            for j in 0..D {
                let sum = axes.eigenvalues[i] + axes.eigenvalues[j];
                skew[(i, j)] = if sum > 0.0 { skew[(i, j)] / sum } else { 0.0 };
            }
        }
        let skew = &axes.eigenvectors * skew * axes.eigenvectors.transpose();
        let skew = SMatrix::from_fn(|i, j| 0.5 * (skew[(i, j)] - skew[(j, i)]));
        Self { rows: rows.to_vec(), middle, along, skew }
    }

    fn put(&self, from: &[[f64; D]], way: &[Vector<D>], part: f64, coords: &mut [[f64; D]]) {
        let angle = (0.5 * self.skew.norm_squared()).sqrt();
        let axis = if angle > 0.0 { self.skew / angle } else { self.skew };
        let turn = turn_about(&axis, part * angle);
        for &row in &self.rows {
            let arm = Vector::from(from[row]) - self.middle;
            let deformation = way[row] - self.along - self.skew * arm;
            coords[row] = (self.middle + self.along * part + turn * (arm + deformation * part)).into();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By 0.37 in a thousandth of its way.
    #[test]
    fn a_body_that_goes_on_turning_keeps_its_shape() {
        let from: Vec<[f64; 3]> =
            vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.5], [1.0, 1.0, 2.0], [-1.0, 2.0, 0.3]];
        let skew = SMatrix::<f64, 3, 3>::new(0.0, -0.3, 0.2, 0.3, 0.0, -0.1, -0.2, 0.1, 0.0) * 1e3;
        let middle = from.iter().map(|x| Vector::from(*x)).sum::<Vector<3>>() / 5.0;
        let along = Vector::<3>::new(7.0, 1.0, -3.0);
        let way = |x: &[f64; 3]| along + skew * (Vector::from(*x) - middle);
        let way: Vec<Vector<3>> = from.iter().map(way).collect();
        let rows: Vec<usize> = (0..5).collect();
        let body = Turning::new(&rows, &from, &way);
        assert!((body.skew - skew).amax() < 1e-9 && (body.along - along).amax() < 1e-12);
        let mut coords = from.clone();
        body.put(&from, &way, 1e-3, &mut coords);
        let distance =
            |points: &[[f64; 3]], i: usize, j: usize| (Vector::from(points[i]) - Vector::from(points[j])).norm();
        for i in 0..5 {
            for j in 0..i {
                assert!((distance(&coords, i, j) - distance(&from, i, j)).abs() < 1e-12);
            }
        }
        let moved = coords.iter().map(|x| Vector::from(*x)).sum::<Vector<3>>() / 5.0 - middle;
        assert!((moved - along * 1e-3).norm() < 1e-12);
    }
}
