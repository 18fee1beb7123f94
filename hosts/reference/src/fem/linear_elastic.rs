//! Hooke's law.

use super::Material;
use super::tensor::{Tensor, from_fn};

/// W = λ/2 (tr ε)² + μ ε:ε with ε = (H + Hᵀ)/2.
#[derive(Clone, Copy, Debug)]
pub(super) struct LinearElastic {
    lame: f64,
    shear: f64,
}

impl LinearElastic {
    pub(super) fn new(material: &Material) -> Self {
        Self { lame: material.lame(), shear: material.shear_modulus() }
    }

    /// Stress λ tr ε I + 2μ ε and W, which is half their product.
    #[inline(always)]
    pub(super) fn stress<const D: usize>(&self, h: &Tensor<D>) -> (Tensor<D>, f64) {
        let mut trace = 0.0;
        (0..D).for_each(|i| trace += h[i][i]);
        let stress: Tensor<D> = from_fn(|i, j| {
            let spherical = if i == j { self.lame * trace } else { 0.0 };
            spherical + self.shear * (h[i][j] + h[j][i])
        });
        (stress, 0.5 * super::tensor::contract(&stress, h))
    }
}
