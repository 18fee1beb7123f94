//! Displacements of points as those of the unknowns of a basis.

use crate::geometry::PointWeights;

/// Part of the right side that is left, and steps at most: what is found is measured by, no more.
const LEFT: f64 = 1e-6;
const MOST: usize = 200;

/// Rows of coordinates that move points nearest to these displacements, which are `None` for points that do not matter. A row that moves
/// nothing, or that `is_moved` says of that it does not move, stays.
pub(crate) fn projected<const D: usize>(
    weights: &PointWeights,
    displacements: &[Option<[f64; D]>],
    is_moved: &[[bool; D]],
) -> Vec<[f64; D]> {
    let mut found = vec![[0.0; D]; is_moved.len()];
    for axis in 0..D {
        let problem = Problem { weights, displacements, is_moved, axis };
        for (row, value) in found.iter_mut().zip(problem.solution()) {
            row[axis] = value;
        }
    }
    found
}

/// Least squares of one axis, by conjugate gradients of the normal equations with their diagonal.
struct Problem<'a, const D: usize> {
    weights: &'a PointWeights,
    displacements: &'a [Option<[f64; D]>],
    is_moved: &'a [[bool; D]],
    axis: usize,
}

impl<const D: usize> Problem<'_, D> {
    fn entries(&self, point: usize) -> impl Iterator<Item = (usize, f64)> {
        let all = self.weights.row(point).map(|(row, weight)| (row as usize, weight));
        all.filter(|(row, _)| self.is_moved[*row][self.axis])
    }

    /// Pᵀ of what `of_point` says of every point that matters.
    fn back(&self, of_point: impl Fn(usize, [f64; D]) -> f64) -> Vec<f64> {
        let mut sums = vec![0.0; self.is_moved.len()];
        for (point, displacement) in self.displacements.iter().enumerate() {
            let Some(displacement) = displacement else { continue };
            let value = of_point(point, *displacement);
            self.entries(point).for_each(|(row, weight)| sums[row] += weight * value);
        }
        sums
    }

    fn solution(&self) -> Vec<f64> {
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut diagonal = vec![0.0; self.is_moved.len()];
        for (point, _) in self.displacements.iter().enumerate().filter(|(_, wanted)| wanted.is_some()) {
            self.entries(point).for_each(|(row, weight)| diagonal[row] += weight * weight);
        }
        let by_diagonal = |v: &[f64]| -> Vec<f64> {
            v.iter().zip(&diagonal).map(|(v, d)| if *d > 0.0 { v / d } else { 0.0 }).collect()
        };
        let mut x = vec![0.0; self.is_moved.len()];
        let mut rest = self.back(|_, displacement| displacement[self.axis]);
        let mut along = by_diagonal(&rest);
        let mut size = dot(&rest, &along);
        let enough = LEFT * LEFT * size;
        for _ in 0..MOST {
            if size <= enough {
                break;
            }
            let product = self.back(|point, _| self.entries(point).map(|(row, weight)| weight * along[row]).sum());
            let part = size / dot(&along, &product);
            if !part.is_finite() {
                break;
            }
            x.iter_mut().zip(&along).for_each(|(x, along)| *x += part * along);
            rest.iter_mut().zip(&product).for_each(|(rest, product)| *rest -= part * product);
            let next = by_diagonal(&rest);
            let smaller = dot(&rest, &next);
            along.iter_mut().zip(&next).for_each(|(along, next)| *along = next + *along * (smaller / size));
            size = smaller;
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three points on a line, moved by its ends: a line comes back, and a row that does not move is left out.
    #[test]
    fn what_unknowns_can_move_comes_back() {
        let weights =
            PointWeights { starts: vec![0, 1, 3, 4], nodes: vec![0, 0, 1, 1], weights: vec![1.0, 0.5, 0.5, 1.0] };
        let line = [Some([1.0, 0.0]), Some([2.0, 0.5]), Some([3.0, 1.0])];
        let found = projected(&weights, &line, &[[true; 2], [true; 2], [true; 2]]);
        for (found, expected) in found.iter().zip([[1.0, 0.0], [3.0, 1.0], [0.0, 0.0]]) {
            assert!((0..2).all(|axis| (found[axis] - expected[axis]).abs() < 1e-6), "{found:?}");
        }
        let found = projected(&weights, &line, &[[false, true], [true; 2]]);
        // The second end alone: ½ x = 2 and x = 3, by least squares 3.2.
        assert!((found[1][0] - 3.2).abs() < 1e-6 && found[0][0] == 0.0, "{found:?}");
        assert_eq!(projected::<2>(&weights, &[None, None, None], &[[true; 2]; 2]), [[0.0; 2]; 2]);
    }
}
