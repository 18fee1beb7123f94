//! Determinants and cofactors of 2 × 2 and 3 × 3 tensors, without loops over signs.

use super::tensor::{Tensor, from_fn};

/// Cofactor C = ∂(det F)/∂F = det F · F⁻ᵀ.
#[inline(always)]
pub(super) fn cofactor<const D: usize>(f: &Tensor<D>) -> Tensor<D> {
    from_fn(|i, j| {
        let at = |k: usize, l: usize| f[(i + k) % D][(j + l) % D];
        match D {
            2 if i == j => at(1, 1),
            2 => -at(1, 1),
            _ => at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1),
        }
    })
}

/// Change of the cofactor with F along `df`; in 2D, where the cofactor is linear, the cofactor of `df`.
#[inline(always)]
pub(super) fn cofactor_derivative<const D: usize>(f: &Tensor<D>, df: &Tensor<D>) -> Tensor<D> {
    if D == 2 {
        return cofactor(df);
    }
    from_fn(|i, j| {
        let at = |t: &Tensor<D>, k: usize, l: usize| t[(i + k) % D][(j + l) % D];
        at(f, 1, 1) * at(df, 2, 2) + at(df, 1, 1) * at(f, 2, 2)
            - at(f, 1, 2) * at(df, 2, 1)
            - at(df, 1, 2) * at(f, 2, 1)
    })
}

/// det(I + H) − 1 by the invariants of H, without the cancellation of the difference.
#[inline(always)]
pub(super) fn dilation<const D: usize>(h: &Tensor<D>) -> f64 {
    let minor = |i: usize, j: usize| h[i % D][i % D] * h[j % D][j % D] - h[i % D][j % D] * h[j % D][i % D];
    if D == 2 {
        return h[0][0] + h[1][1] + minor(0, 1);
    }
    let c = cofactor(h);
    let determinant = h[0][0] * c[0][0] + h[0][1] * c[0][1] + h[0][2 % D] * c[0][2 % D];
    h[0][0] + h[1][1] + h[2 % D][2 % D] + (minor(0, 1) + minor(1, 2) + minor(2, 0)) + determinant
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dilation_is_the_change_of_volume() {
        // Shear and stretch: det = 1.5 · 0.8 · 1.1 whatever stands above the diagonal.
        let h = [[0.5, 0.7, -0.3], [0.0, -0.2, 0.9], [0.0, 0.0, 0.1]];
        assert!((dilation(&h) - (1.5 * 0.8 * 1.1 - 1.0)).abs() < 1e-15);
        assert!((dilation(&[[0.5, 0.7], [0.0, -0.2]]) - (1.5 * 0.8 - 1.0)).abs() < 1e-15);
        assert!((dilation(&[[1e-12, 0.0], [0.0, 1e-12]]) / 2e-12 - 1.0).abs() < 1e-11);
    }
}
