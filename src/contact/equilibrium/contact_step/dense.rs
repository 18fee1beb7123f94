//! Dense systems that say why they have no solution.

#[cfg(feature = "solver")]
use super::large;
use nalgebra::{Cholesky, DMatrix, DVector};

/// Why a matrix is not positive definite, or has no inverse, found at a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Defect {
    /// To rounding.
    Singular {
        row: usize,
    },
    Indefinite {
        row: usize,
        pivot: f64,
    },
}

/// Part of a diagonal entry at which a pivot has lost all its digits.
fn rounding(matrix: &DMatrix<f64>) -> f64 {
    matrix.nrows() as f64 * f64::EPSILON
}

/// Solution of a symmetric positive definite system, by Cholesky's factors.
pub(super) fn solve_definite(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Result<DVector<f64>, Defect> {
    if_definite(matrix, right).map_err(|lost| match lost {
        Some(row) => Defect::Singular { row },
        None => defect(matrix),
    })
}

/// The same where it is not asked what is wrong: then a row at which the matrix is singular, or none.
pub(super) fn if_definite(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Result<DVector<f64>, Option<usize>> {
    let lost = |lower: &DMatrix<f64>| {
        let is_lost = |row: &usize| {
            let pivot = lower[(*row, *row)] * lower[(*row, *row)];
            pivot <= rounding(matrix) * matrix[(*row, *row)] || !pivot.is_finite()
        };
        (0..matrix.nrows()).find(is_lost).map_or(Ok(()), |row| Err(Some(row)))
    };
    #[cfg(feature = "solver")]
    if matrix.nrows() >= large::FROM {
        let lower = large::cholesky(matrix.clone()).ok_or(None)?;
        lost(&lower)?;
        return Ok(large::solve_cholesky(&lower, right));
    }
    let factors = Cholesky::new(matrix.clone()).ok_or(None)?;
    lost(factors.l_dirty())?;
    Ok(factors.solve(right))
}

/// The first pivot of Cholesky's method that is not positive: those before it are, so that it tells of the matrix.
fn defect(matrix: &DMatrix<f64>) -> Defect {
    let mut left = matrix.clone();
    let count = left.nrows();
    for row in 0..count {
        let pivot = left[(row, row)];
        let lost = rounding(matrix) * matrix[(row, row)].abs();
        if pivot.is_nan() || pivot.abs() <= lost {
            return Defect::Singular { row };
        }
        if pivot < 0.0 {
            return Defect::Indefinite { row, pivot };
        }
        for col in row + 1..count {
            let factor = left[(row, col)] / pivot;
            for below in col..count {
                left[(col, below)] -= factor * left[(row, below)];
            }
        }
    }
    Defect::Singular { row: count.saturating_sub(1) }
}

/// Solution of a system, by Gauss' elimination with partial pivoting.
pub(super) fn solve_general(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Result<DVector<f64>, Defect> {
    // Columns are measured by themselves: those of the contact are stiffer than those of the bodies.
    let lost = |pivots: &[f64]| {
        let is_lost = |row: &usize| {
            let pivot = pivots[*row].abs();
            pivot.is_nan() || pivot <= rounding(matrix) * matrix.column(*row).amax()
        };
        (0..matrix.nrows()).find(is_lost).map_or(Ok(()), |row| Err(Defect::Singular { row }))
    };
    #[cfg(feature = "solver")]
    if matrix.nrows() >= large::FROM {
        let (found, pivots) = large::solve_general(matrix.clone(), right);
        return lost(&pivots).map(|()| found);
    }
    let factors = matrix.clone().lu();
    lost(factors.u().diagonal().as_slice())?;
    factors.solve(right).ok_or(Defect::Singular { row: 0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Large and small systems are solved by different libraries: each with one whose solution is known, and with defects where
    /// they were put.
    #[test]
    fn systems_of_any_size_are_solved_or_told_of() {
        for count in [3, 60, 199, 200, 333] {
            let entry = |i: usize, j: usize| (i * 7 + j * 13 % 5) as f64 % 1.7 - 0.8;
            let general =
                DMatrix::from_fn(count, count, |i, j| entry(i, j) + if (i + 1) % count == j { 9.0 } else { 0.0 });
            let factor = DMatrix::from_fn(count, count, |i, j| {
                if i == j {
                    3.0
                } else if i > j {
                    entry(i, j) / count as f64
                } else {
                    0.0
                }
            });
            let definite = &factor * factor.transpose();
            let x = DVector::from_fn(count, |i, _| (i as f64).sin());
            let found = solve_definite(&definite, &(&definite * &x)).unwrap();
            assert!((found - &x).amax() < 1e-12, "{count}");
            let found = solve_general(&general, &(&general * &x)).unwrap();
            assert!((found - &x).amax() < 1e-9, "{count}: {}", general.norm());

            let row = count - 2;
            let mut indefinite = definite.clone();
            indefinite[(row, row)] -= 100.0;
            let told = solve_definite(&indefinite, &x).unwrap_err();
            assert!(
                matches!(told, Defect::Indefinite { row: found, pivot } if found == row && (pivot + 91.0).abs() < 1e-9),
                "{told:?}"
            );
            let mut singular = factor.clone();
            singular[(row, row)] = 0.0;
            let told = solve_definite(&(&singular * singular.transpose()), &x).unwrap_err();
            assert!(
                matches!(told, Defect::Singular { row: found } | Defect::Indefinite { row: found, .. } if found == row),
                "{told:?}"
            );
            let mut repeated = general.clone();
            let column = repeated.column(0).clone_owned();
            repeated.set_column(row, &(column * 2.0));
            assert!(matches!(solve_general(&repeated, &x), Err(Defect::Singular { .. })), "{count}");
        }
    }

    #[test]
    fn what_is_wrong_with_a_matrix_is_told() {
        let right = DVector::from_column_slice(&[1.0, 2.0]);
        let of = |values: [f64; 4]| DMatrix::from_row_slice(2, 2, &values);
        // Pivots of which the roots have no rounding.
        assert_eq!(solve_definite(&of([4.0, 0.0, 0.0, 16.0]), &right), Ok(DVector::from_column_slice(&[0.25, 0.125])));
        assert_eq!(solve_definite(&of([1.0, 1.0, 1.0, 1.0]), &right), Err(Defect::Singular { row: 1 }));
        // One bit above what is singular to rounding.
        assert_eq!(solve_definite(&of([1.0, 1.0, 1.0, 1.0 + 2e-16]), &right), Err(Defect::Singular { row: 1 }));
        let indefinite = Defect::Indefinite { row: 1, pivot: -3.0 };
        assert_eq!(solve_definite(&of([1.0, 2.0, 2.0, 1.0]), &right), Err(indefinite));
        assert_eq!(solve_definite(&of([0.0, 0.0, 0.0, 1.0]), &right), Err(Defect::Singular { row: 0 }));
        assert_eq!(solve_general(&of([0.0, 1.0, 1.0, 0.0]), &right), Ok(DVector::from_column_slice(&[2.0, 1.0])));
        assert_eq!(solve_general(&of([1.0, 2.0, 2.0, 4.0]), &right), Err(Defect::Singular { row: 1 }));
        // Units do not matter.
        assert!(solve_definite(&of([1e-30, 0.0, 0.0, 1e30]), &right).is_ok());
        assert!(solve_general(&of([1e-30, 0.0, 0.0, 1e30]), &right).is_ok());
    }
}
