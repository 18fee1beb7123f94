//! Tensors as arrays of arrays.

/// Second-order tensor by rows.
pub(super) type Tensor<const D: usize> = [[f64; D]; D];

/// Square array by its indices.
#[inline(always)]
pub(super) fn from_fn<T, const D: usize>(entry: impl Fn(usize, usize) -> T) -> [[T; D]; D] {
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

/// Double contraction a : b.
#[inline(always)]
pub(super) fn contract<const D: usize>(a: &Tensor<D>, b: &Tensor<D>) -> f64 {
    let mut sum = 0.0;
    for i in 0..D {
        for j in 0..D {
            sum += a[i][j] * b[i][j];
        }
    }
    sum
}
