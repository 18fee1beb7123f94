//! The neo-Hookean solid.
//!
//! With C = ∂J/∂F = cof F, a = G J^(−2/3) and b = K (J − 1) − a I₁/3J,
//!
//! ```text
//! P  = a F + b C
//! dP = a dF + b dC + da F + db C        da = −2/3 a/J dJ,  dJ = C:dF
//!                                       db = (K + 5/9 a I₁/J²) dJ − 2/3 a/J F:dF
//! ```

use super::Material;
use super::cofactor::{cofactor, cofactor_derivative, dilation};
use super::cube_root::inverse_cube_root;
use super::tensor::{Tensor, contract, from_fn};

/// W = G/2 (J^(−2/3) I₁ − 3) + K/2 (J − 1)².
#[derive(Clone, Copy, Debug)]
pub(super) struct NeoHookean {
    shear: f64,
    bulk: f64,
}

/// A deformation and what all derivatives of W there share.
pub(super) struct State<const D: usize> {
    f: Tensor<D>,
    cofactor: Tensor<D>,
    /// J − 1, without cancellation for small H.
    dilation: f64,
    i1: f64,
    a: f64,
    b: f64,
    bulk: f64,
}

impl NeoHookean {
    pub(super) fn new(material: &Material) -> Self {
        Self { shear: material.shear_modulus(), bulk: material.bulk_modulus() }
    }

    /// State at H. In 2D F_zz = 1.
    #[inline(always)]
    pub(super) fn at<const D: usize>(&self, h: &Tensor<D>) -> State<D> {
        let f: Tensor<D> = from_fn(|i, j| h[i][j] + if i == j { 1.0 } else { 0.0 });
        let dilation = dilation(h);
        let j = 1.0 + dilation;
        let i1 = contract(&f, &f) + (3 - D) as f64;
        let root = inverse_cube_root(j);
        let a = self.shear * root * root;
        let b = self.bulk * dilation - a * i1 / (3.0 * j);
        State { cofactor: cofactor(&f), f, dilation, i1, a, b, bulk: self.bulk }
    }

    /// P and W; W is infinite if J ≤ 0.
    #[inline(always)]
    pub(super) fn stress<const D: usize>(&self, h: &Tensor<D>) -> (Tensor<D>, f64) {
        let state = self.at(h);
        let energy = 0.5 * (state.a * state.i1 - 3.0 * self.shear + self.bulk * state.dilation * state.dilation);
        (state.stress(), if state.dilation > -1.0 { energy } else { f64::INFINITY })
    }
}

impl<const D: usize> State<D> {
    #[inline(always)]
    fn stress(&self) -> Tensor<D> {
        from_fn(|i, j| self.a * self.f[i][j] + self.b * self.cofactor[i][j])
    }

    /// dP for dF = dH.
    #[inline(always)]
    pub(super) fn stress_derivative(&self, dh: &Tensor<D>) -> Tensor<D> {
        let j = 1.0 + self.dilation;
        let dj = contract(&self.cofactor, dh);
        let da = -2.0 / 3.0 * self.a / j * dj;
        let db =
            (self.bulk + 5.0 / 9.0 * self.a * self.i1 / (j * j)) * dj - 2.0 / 3.0 * self.a / j * contract(&self.f, dh);
        let change = cofactor_derivative(&self.f, dh);
        from_fn(|i, k| self.a * dh[i][k] + self.b * change[i][k] + da * self.f[i][k] + db * self.cofactor[i][k])
    }
}

impl State<3> {
    /// σ = P Fᵀ/J.
    pub(super) fn cauchy(&self) -> Tensor<3> {
        let p = self.stress();
        from_fn(|i, j| (0..3).map(|k| p[i][k] * self.f[j][k]).sum::<f64>() / (1.0 + self.dilation))
    }
}
