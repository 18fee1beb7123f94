//! Hooke's law.

use super::tensor::{Tensor, from_fn};
use super::{Law, Material};

/// W = λ/2 (tr ε)² + μ ε:ε with ε = (H + Hᵀ)/2.
#[derive(Clone, Copy, Debug)]
pub(super) struct LinearElastic {
    lame: f64,
    shear: f64,
    is_plane_stress: bool,
}

impl LinearElastic {
    pub(super) fn new(material: &Material) -> Self {
        let (lame, shear) = (material.lame(), material.shear_modulus());
        let is_plane_stress = material.law == Law::PlaneStress;
        let lame = if is_plane_stress { 2.0 * lame * shear / (lame + 2.0 * shear) } else { lame };
        Self { lame, shear, is_plane_stress }
    }

    /// Cauchy stress, with that across the plane.
    pub(super) fn cauchy(&self, h: &Tensor<3>) -> Tensor<3> {
        let mut stress = self.stress(h).0;
        if self.is_plane_stress {
            stress[2][2] = 0.0;
        }
        stress
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
