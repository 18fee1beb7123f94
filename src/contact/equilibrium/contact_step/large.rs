//! Dense systems that are large: faer's factors take a tenth of the time of nalgebra's. On one thread, so that the bits do not
//! depend on their number.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt;
use faer::linalg::lu::partial_pivoting as lu;
use faer::prelude::default;
use faer::{MatMut, MatRef, Par};
use nalgebra::{DMatrix, DVector};

/// Equations from which on it is faster.
pub(super) const FROM: usize = 200;

/// Cholesky's factor L, of which only the lower triangle counts; `None` where a pivot is not positive.
pub(super) fn cholesky(mut matrix: DMatrix<f64>) -> Option<DMatrix<f64>> {
    let count = matrix.nrows();
    let mut memory = MemBuffer::new(llt::factor::cholesky_in_place_scratch::<f64>(count, Par::Seq, default()));
    let stack = MemStack::new(&mut memory);
    let of_faer = MatMut::from_column_major_slice_mut(matrix.as_mut_slice(), count, count);
    llt::factor::cholesky_in_place(of_faer, default(), Par::Seq, stack, default()).ok()?;
    Some(matrix)
}

/// Solution of L Lᵀ x = b.
pub(super) fn solve_cholesky(lower: &DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let mut x = right.clone();
    let (factor, of_faer) = (of(lower), MatMut::from_column_major_slice_mut(x.as_mut_slice(), right.len(), 1));
    let mut memory = MemBuffer::new(llt::solve::solve_in_place_scratch::<f64>(right.len(), 1, Par::Seq));
    llt::solve::solve_in_place(factor, of_faer, Par::Seq, MemStack::new(&mut memory));
    x
}

/// Solution by Gauss' elimination with partial pivoting, and the pivots.
pub(super) fn solve_general(mut matrix: DMatrix<f64>, right: &DVector<f64>) -> (DVector<f64>, Vec<f64>) {
    let (count, mut x) = (matrix.nrows(), right.clone());
    let (mut order, mut back) = (vec![0usize; count], vec![0usize; count]);
    let of_faer = MatMut::from_column_major_slice_mut(matrix.as_mut_slice(), count, count);
    let mut memory = MemBuffer::new(lu::factor::lu_in_place_scratch::<usize, f64>(count, count, Par::Seq, default()));
    let stack = MemStack::new(&mut memory);
    let (_, permutation) = lu::factor::lu_in_place(of_faer, &mut order, &mut back, Par::Seq, stack, default());
    let mut memory = MemBuffer::new(lu::solve::solve_in_place_scratch::<usize, f64>(count, 1, Par::Seq));
    let of_faer = MatMut::from_column_major_slice_mut(x.as_mut_slice(), count, 1);
    // Both triangles in one.
    let factors = of(&matrix);
    lu::solve::solve_in_place(factors, factors, permutation, of_faer, Par::Seq, MemStack::new(&mut memory));
    (x, (0..count).map(|row| matrix[(row, row)]).collect())
}

fn of(matrix: &DMatrix<f64>) -> MatRef<'_, f64> {
    MatRef::from_column_major_slice(matrix.as_slice(), matrix.nrows(), matrix.ncols())
}
