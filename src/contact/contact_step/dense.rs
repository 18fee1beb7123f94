//! Dense systems that say why they have no solution.

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
    let Some(factors) = Cholesky::new(matrix.clone()) else { return Err(defect(matrix)) };
    let lower = factors.l_dirty();
    let lost = |row: &usize| {
        let pivot = lower[(*row, *row)] * lower[(*row, *row)];
        pivot <= rounding(matrix) * matrix[(*row, *row)] || !pivot.is_finite()
    };
    match (0..matrix.nrows()).find(lost) {
        Some(row) => Err(Defect::Singular { row }),
        None => Ok(factors.solve(right)),
    }
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
    let factors = matrix.clone().lu();
    let upper = factors.u();
    // Columns are measured by themselves: those of the contact are stiffer than those of the bodies.
    let lost = |row: &usize| {
        let pivot = upper[(*row, *row)].abs();
        pivot.is_nan() || pivot <= rounding(matrix) * matrix.column(*row).amax()
    };
    if let Some(row) = (0..matrix.nrows()).find(lost) {
        return Err(Defect::Singular { row });
    }
    factors.solve(right).ok_or(Defect::Singular { row: 0 })
}

#[cfg(test)]
mod tests {
    use super::*;

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
