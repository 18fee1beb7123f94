//! A profile through space.

use super::path::{Path, beside};
use crate::layer::Front;

/// Axes of a profile, each of length 1: along its first and second coordinate, and across both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frame {
    pub(crate) origin: [f64; 3],
    pub(crate) axes: [[f64; 3]; 3],
}

/// How a profile goes through space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Sweep {
    /// Not at all.
    Plane,
    /// From one place to another along the third axis.
    Along([f64; 2]),
    /// Around the second axis, from which the first coordinate is a radius, in so many parts.
    Around(usize),
}

/// Nodes and faces of a swept profile, and how far faces lie beside it, at most.
pub(crate) type Swept = (Vec<[f64; 3]>, Vec<Front>, f64);

/// Sweeps a profile; nodes are numbered from `first`.
///
/// # Errors
/// A sentence about a radius below 0.
pub(crate) fn swept(path: &Path, frame: &Frame, sweep: Sweep, first: usize) -> Result<Swept, String> {
    let mut nodes = Nodes { points: Vec::new(), first, frame };
    let edges = path.middles.len();
    match sweep {
        Sweep::Plane => {
            let [corners, middles] = [&path.corners, &path.middles]
                .map(|all| all.iter().map(|x| nodes.add([x[0], x[1], 0.0])).collect::<Vec<_>>());
            let fronts =
                (0..edges).map(|k| Front { corners: vec![corners[k], corners[k + 1]], middles: vec![middles[k]] });
            Ok((nodes.points, fronts.collect(), path.off))
        }
        Sweep::Along(ends) => {
            let middle = 0.5 * (ends[0] + ends[1]);
            let mut row = |all: &[[f64; 2]], place: f64| -> Vec<usize> {
                all.iter().map(|x| nodes.add([x[0], x[1], place])).collect()
            };
            let corners = ends.map(|place| row(&path.corners, place));
            let middles = ends.map(|place| row(&path.middles, place));
            let upright = row(&path.corners, middle);
            let front = |k: usize| Front {
                corners: vec![corners[1][k], corners[1][k + 1], corners[0][k + 1], corners[0][k]],
                middles: vec![middles[1][k], upright[k + 1], middles[0][k], upright[k]],
            };
            Ok((nodes.points, (0..edges).map(front).collect(), path.off))
        }
        Sweep::Around(count) => around(path, nodes, count),
    }
}

struct Nodes<'a> {
    points: Vec<[f64; 3]>,
    first: usize,
    frame: &'a Frame,
}

impl Nodes<'_> {
    fn add(&mut self, local: [f64; 3]) -> usize {
        let Frame { origin, axes } = self.frame;
        self.points
            .push(std::array::from_fn(|k| origin[k] + (0..3).map(|axis| local[axis] * axes[axis][k]).sum::<f64>()));
        self.first + self.points.len() - 1
    }

    /// A ring of nodes at places `places` of a turn in degrees; on the axis it is one node.
    fn ring(&mut self, [radius, height]: [f64; 2], places: &[f64], is_on_axis: bool) -> Vec<usize> {
        if is_on_axis {
            return vec![self.add([0.0, height, 0.0]); places.len()];
        }
        let at = |degrees: &f64| {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            // From the first axis towards the third with its sign changed: first, second and this are left-handed.
            self.add([radius * cosine, height, -radius * sine])
        };
        places.iter().map(at).collect()
    }
}

fn around(path: &Path, mut nodes: Nodes, count: usize) -> Result<Swept, String> {
    let largest = path.corners.iter().map(|x| x[0]).fold(0.0, f64::max);
    let is_on_axis = |x: &[f64; 2]| x[0].abs() <= 1e-9 * largest;
    if let Some(x) = path.corners.iter().chain(&path.middles).find(|x| x[0] < 0.0 && !is_on_axis(x)) {
        return Err(format!("a radius of {} is below 0", x[0]));
    }
    if path.corners.windows(2).any(|ends| ends.iter().all(is_on_axis)) {
        return Err("a segment lies on the axis".to_owned());
    }
    let angle = 360.0 / count as f64;
    let whole: Vec<f64> = (0..count).map(|k| k as f64 * angle).collect();
    let halves: Vec<f64> = whole.iter().map(|place| place + 0.5 * angle).collect();
    let corners: Vec<Vec<usize>> = path.corners.iter().map(|x| nodes.ring(*x, &whole, is_on_axis(x))).collect();
    let between: Vec<Vec<usize>> = path.corners.iter().map(|x| nodes.ring(*x, &halves, is_on_axis(x))).collect();
    let middles: Vec<Vec<usize>> = path.middles.iter().map(|x| nodes.ring(*x, &whole, false)).collect();
    let mut fronts = Vec::new();
    for k in 0..path.middles.len() {
        for j in 0..count {
            let next = (j + 1) % count;
            let [low, high] = [k, k + 1].map(|k| is_on_axis(&path.corners[k]));
            let mut front = Front {
                corners: vec![corners[k][j], corners[k + 1][j], corners[k + 1][next], corners[k][next]],
                middles: vec![middles[k][j], between[k + 1][j], middles[k][next], between[k][j]],
            };
            // An edge on the axis is a point.
            if low || high {
                let place = if high { [2, 1] } else { [3, 3] };
                front.corners.remove(place[0]);
                front.middles.remove(place[1]);
            }
            fronts.push(front);
        }
    }
    let off = path.off.max(beside(largest, 0.5 * angle.to_radians()));
    Ok((nodes.points, fronts, off))
}

#[cfg(test)]
mod tests {
    use super::super::{Piece, Profile, path};
    use super::*;

    const FRAME: Frame = Frame { origin: [1.0, 2.0, 3.0], axes: [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]] };

    fn quarter() -> Path {
        let arc = Piece::Arc { end: [2.0, 0.0], centre: [0.0; 2] };
        path(&Profile { start: [0.0, 2.0], pieces: vec![(1, arc)] }, 5.0).unwrap()
    }

    /// The normal of a face by its first three corners.
    fn normal(points: &[[f64; 3]], front: &Front) -> [f64; 3] {
        let at = |k: usize| points[front.corners[k]];
        let [u, v]: [[f64; 3]; 2] = [1, 2].map(|k| std::array::from_fn(|i| at(k)[i] - at(0)[i]));
        std::array::from_fn(|k| u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3])
    }

    /// A quarter of a circle from its top, with the outside to the left, makes half of a ball around its axis, and a quarter of a cylinder along it: all
    /// nodes are on it, all faces look outwards.
    #[test]
    fn a_quarter_of_a_circle_makes_a_ball_and_a_cylinder() {
        for (sweep, count) in [(Sweep::Around(72), 18 * 72), (Sweep::Along([-1.0, 4.0]), 18)] {
            let (points, fronts, off) = swept(&quarter(), &FRAME, sweep, 0).unwrap();
            assert!(fronts.len() == count && off < 2.3e-7, "{off:e}");
            let from_middle = |x: [f64; 3]| {
                let x: [f64; 3] = std::array::from_fn(|k| x[k] - FRAME.origin[k]);
                if sweep == Sweep::Around(72) { x } else { [0.0, x[1], x[2]] }
            };
            for x in &points {
                let radius = from_middle(*x).iter().map(|x| x * x).sum::<f64>().sqrt();
                assert!((radius - 2.0).abs() < 1e-14, "{x:?}");
            }
            for front in &fronts {
                let (normal, x) = (normal(&points, front), from_middle(points[front.corners[1]]));
                assert!((0..3).map(|k| normal[k] * x[k]).sum::<f64>() > 0.0, "{front:?}");
                assert_eq!(front.corners.len(), front.middles.len());
            }
        }
    }

    #[test]
    fn middles_lie_between_their_corners() {
        for sweep in [Sweep::Around(72), Sweep::Along([-1.0, 4.0])] {
            let (points, fronts, _) = swept(&quarter(), &FRAME, sweep, 0).unwrap();
            let distance =
                |p: usize, q: usize| (0..3).map(|k| (points[p][k] - points[q][k]).powi(2)).sum::<f64>().sqrt();
            for front in &fronts {
                let count = front.corners.len();
                for (k, &middle) in front.middles.iter().enumerate() {
                    let ends = [front.corners[k], front.corners[(k + 1) % count]];
                    let [a, b] = ends.map(|end| distance(end, middle));
                    assert!((a - b).abs() < 1e-12 && a < 0.51 * distance(ends[0], ends[1]) + 1e-9, "{front:?} {k}");
                }
            }
        }
    }
}
