//! Passes through a lower triangle, column after column.

use faer::MatRef;

/// y += a x.
pub(super) fn axpy(a: f64, x: &[f64], y: &mut [f64]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += a * x);
}

/// x·y, as eight sums: one alone would wait for itself.
pub(super) fn dot(x: &[f64], y: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (mut left, mut right) = (x.chunks_exact(8), y.chunks_exact(8));
    for (x, y) in left.by_ref().zip(right.by_ref()) {
        (0..8).for_each(|k| sums[k] += x[k] * y[k]);
    }
    let rest: f64 = left.remainder().iter().zip(right.remainder()).map(|(x, y)| x * y).sum();
    sums.iter().sum::<f64>() + rest
}

/// A column of a matrix whose columns lie in one piece.
pub(super) fn column<'a>(matrix: MatRef<'a, f64>, number: usize) -> &'a [f64] {
    matrix.col(number).try_as_col_major().map_or(&[], |column| column.as_slice())
}

/// Forward substitution of the first `count` columns of L: x becomes L⁻¹ x there, and what is left of x below.
pub(super) fn forward(lower: MatRef<f64>, count: usize, x: &mut [f64]) {
    for j in 0..count {
        let (from, below) = x[j..].split_at_mut(1);
        let column = &column(lower, j)[j..];
        from[0] /= column[0];
        axpy(-from[0], &column[1..], below);
    }
}

/// Backward substitution of the first `count` columns of L: with x below as it is, x becomes L⁻ᵀ x there.
pub(super) fn backward(lower: MatRef<f64>, count: usize, x: &mut [f64]) {
    for j in (0..count).rev() {
        let (to, below) = x[j..].split_at_mut(1);
        let column = &column(lower, j)[j..];
        to[0] = (to[0] - dot(&column[1..], below)) / column[0];
    }
}
