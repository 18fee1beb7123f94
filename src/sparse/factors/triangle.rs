//! Substitutions with lower triangles, by faer's products and solutions on one thread.

use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, MatMut, MatRef, Par};

/// Forward substitution of the first `count` columns of L: x becomes L⁻¹ x there, and what is left of x below.
pub(super) fn forward(lower: MatRef<f64>, count: usize, x: &mut [f64]) {
    let (above, below) = x.split_at_mut(count);
    let (mut above, below) = (of(above), of(below));
    solve_lower_triangular_in_place(lower.get(..count, ..count), above.as_mut(), Par::Seq);
    matmul(below, Accum::Add, lower.get(count.., ..count), above.as_ref(), -1.0, Par::Seq);
}

/// Backward substitution of the first `count` columns of L: with x below as it is, x becomes L⁻ᵀ x there.
pub(super) fn backward(lower: MatRef<f64>, count: usize, x: &mut [f64]) {
    let (above, below) = x.split_at_mut(count);
    let (mut above, below) = (of(above), of(below));
    let transposed = lower.get(count.., ..count).transpose();
    matmul(above.as_mut(), Accum::Add, transposed, below.as_ref(), -1.0, Par::Seq);
    solve_upper_triangular_in_place(lower.get(..count, ..count).transpose(), above, Par::Seq);
}

/// L Lᵀ x.
pub(super) fn times(lower: MatRef<f64>, x: &[f64]) -> Vec<f64> {
    let (mut half, mut whole) = (vec![0.0; x.len()], vec![0.0; x.len()]);
    let x = MatRef::from_column_major_slice(x, x.len(), 1);
    let [low, up, all] =
        [BlockStructure::TriangularLower, BlockStructure::TriangularUpper, BlockStructure::Rectangular];
    let mut to = of(&mut half);
    triangular::matmul(to.as_mut(), all, Accum::Replace, lower.transpose(), up, x, all, 1.0, Par::Seq);
    triangular::matmul(of(&mut whole), all, Accum::Replace, lower, low, to.as_ref(), all, 1.0, Par::Seq);
    whole
}

/// A column of a matrix whose columns lie in one piece.
pub(super) fn column<'a>(matrix: MatRef<'a, f64>, number: usize) -> &'a [f64] {
    matrix.col(number).try_as_col_major().map_or(&[], |column| column.as_slice())
}

fn of(x: &mut [f64]) -> MatMut<'_, f64> {
    let count = x.len();
    MatMut::from_column_major_slice_mut(x, count, 1)
}
