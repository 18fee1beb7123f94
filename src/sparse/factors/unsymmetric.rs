//! Sparse systems whose matrix is not symmetric.

use super::{Entries, Lower};
use faer::Mat;
use faer::linalg::solvers::Solve;
use faer::sparse::{SparseColMat, Triplet};

/// Solution of a system of a symmetric matrix and other entries, which add up where they coincide, by LU factors; `None`
/// for a singular one.
pub fn solve_unsymmetric(symmetric: &Lower, others: &Entries, right: &[f64]) -> Option<Vec<f64>> {
    let size = symmetric.size();
    let mirrored = symmetric.entries().filter(|(row, column, _)| row != column).map(|(r, c, v)| (c, r, v));
    let entries = symmetric.entries().chain(mirrored).chain(others.iter().copied());
    let triplets: Vec<_> = entries.map(|(row, column, value)| Triplet::new(row, column, value)).collect();
    let matrix = SparseColMat::<usize, f64>::try_new_from_triplets(size, size, &triplets).ok()?;
    let factors = matrix.sp_lu().ok()?;
    let solution = factors.solve(Mat::from_fn(size, 1, |row, _| right[row]));
    let values: Vec<f64> = (0..size).map(|row| solution[(row, 0)]).collect();
    values.iter().all(|x| x.is_finite()).then_some(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_with_a_follower_force_is_solved() {
        // Springs 2 and 3 in a row from a wall; the first is also pushed by 5 times what the second has moved.
        let springs = Lower::new(2, [(0, 0, 5.0), (1, 0, -3.0), (1, 1, 3.0)].into_iter());
        let found = solve_unsymmetric(&springs, &vec![(0, 1, -2.0), (0, 1, -3.0)], &[0.0, 1.0]).unwrap();
        // 5 x − 8 y = 0 and −3 x + 3 y = 1.
        let expected = [-8.0 / 9.0, -5.0 / 9.0];
        found.iter().zip(expected).for_each(|(x, e)| assert!((x - e).abs() < 1e-14, "{found:?}"));
        assert!(solve_unsymmetric(&springs, &vec![(0, 1, 3.0), (0, 0, -5.0)], &[1.0, 1.0]).is_none());
    }
}
