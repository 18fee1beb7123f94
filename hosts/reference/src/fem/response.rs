//! Stress of a material at a displacement gradient.

use super::linear_elastic::LinearElastic;
use super::neo_hookean::NeoHookean;
use super::tensor::{Tensor, from_fn};
use super::{Law, Material};

/// Material with the constants of its law; all methods take H = ∂u/∂X, in 2D that of plane strain.
#[derive(Clone, Copy, Debug)]
pub(super) enum Response {
    LinearElastic(LinearElastic),
    NeoHookean(NeoHookean),
}

impl Response {
    pub(super) fn new(material: &Material) -> Self {
        match material.law {
            Law::LinearElastic | Law::PlaneStress => Response::LinearElastic(LinearElastic::new(material)),
            Law::NeoHookean => Response::NeoHookean(NeoHookean::new(material)),
        }
    }

    /// First Piola–Kirchhoff stress P = ∂W/∂H and energy density W.
    #[inline(always)]
    pub(super) fn stress<const D: usize>(&self, h: &Tensor<D>) -> (Tensor<D>, f64) {
        match self {
            Response::LinearElastic(law) => law.stress(h),
            Response::NeoHookean(law) => law.stress(h),
        }
    }

    /// Change of P with H along `dh`.
    #[inline(always)]
    pub(super) fn stress_derivative<const D: usize>(&self, h: &Tensor<D>, dh: &Tensor<D>) -> Tensor<D> {
        match self {
            Response::LinearElastic(law) => law.stress(dh).0,
            Response::NeoHookean(law) => law.at(h).stress_derivative(dh),
        }
    }

    /// Changes of P with each component of H: `[k][l]` is ∂P/∂H_kl.
    pub(super) fn tangent<const D: usize>(&self, h: &Tensor<D>) -> [[Tensor<D>; D]; D] {
        let unit = |k: usize, l: usize| {
            let mut dh = [[0.0; D]; D];
            dh[k][l] = 1.0;
            dh
        };
        match self {
            Response::LinearElastic(law) => from_fn(|k, l| law.stress(&unit(k, l)).0),
            Response::NeoHookean(law) => {
                let state = law.at(h);
                from_fn(|k, l| state.stress_derivative(&unit(k, l)))
            }
        }
    }

    /// Cauchy stress.
    pub(super) fn cauchy(&self, h: &Tensor<3>) -> Tensor<3> {
        match self {
            Response::LinearElastic(law) => law.cauchy(h),
            Response::NeoHookean(law) => law.at(h).cauchy(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fem::tensor::contract;
    use fmc_shapes::{Splitmix, random_rotation};

    const G: f64 = 50.0 / 1.3;

    fn materials() -> [Response; 2] {
        [Law::LinearElastic, Law::NeoHookean]
            .map(|law| Response::new(&Material { law, young: 100.0, poisson: 0.3, density: 1.0 }))
    }

    fn random_tensor<const D: usize>(random: &mut Splitmix, size: f64) -> Tensor<D> {
        let mut h = [[0.0; D]; D];
        h.iter_mut().flatten().for_each(|h| *h = random.between(-size, size));
        h
    }

    fn moved<const D: usize>(h: &Tensor<D>, dh: &Tensor<D>, step: f64) -> Tensor<D> {
        from_fn(|i, j| h[i][j] + step * dh[i][j])
    }

    /// Central differences: error of order step² and of rounding over step, both near 1e-10 here.
    fn derivatives_agree<const D: usize>() {
        let mut random = Splitmix::new(7);
        for response in materials() {
            for _ in 0..20 {
                let (h, dh) = (random_tensor::<D>(&mut random, 0.3), random_tensor::<D>(&mut random, 1.0));
                let step = 1e-5;
                let [(ahead, more), (behind, less)] = [step, -step].map(|step| response.stress(&moved(&h, &dh, step)));
                let power = contract(&response.stress(&h).0, &dh);
                assert!((power - (more - less) / (2.0 * step)).abs() < 1e-7 * G);
                let derivative = response.stress_derivative(&h, &dh);
                let tangent = response.tangent(&h);
                for i in 0..D {
                    for j in 0..D {
                        let difference = (ahead[i][j] - behind[i][j]) / (2.0 * step);
                        assert!((derivative[i][j] - difference).abs() < 1e-6 * G);
                        let sum: f64 = (0..D * D).map(|m| tangent[m / D][m % D][i][j] * dh[m / D][m % D]).sum();
                        assert!((sum - derivative[i][j]).abs() < 1e-12 * G);
                    }
                }
            }
        }
    }

    #[test]
    fn stress_is_energy_gradient_and_tangent_its_derivative() {
        derivatives_agree::<2>();
        derivatives_agree::<3>();
    }

    /// W of plane strain is W of F with F_zz = 1.
    #[test]
    fn plane_strain_is_a_slice_of_space() {
        let mut random = Splitmix::new(9);
        for response in materials() {
            for _ in 0..20 {
                let h = random_tensor::<2>(&mut random, 0.3);
                let (stress, energy) = response.stress(&h);
                let (in_space, energy_in_space) = response.stress(&embedded(&h));
                assert!((energy - energy_in_space).abs() < 1e-13 * G);
                for i in 0..2 {
                    (0..2).for_each(|j| assert!((stress[i][j] - in_space[i][j]).abs() < 1e-13 * G));
                    assert!(in_space[i][2] == 0.0 && in_space[2][i] == 0.0);
                }
            }
        }
    }

    fn embedded(h: &Tensor<2>) -> Tensor<3> {
        from_fn(|i, j| if i < 2 && j < 2 { h[i][j] } else { 0.0 })
    }

    /// Both laws are Hooke's in the small: W = λ/2 (tr ε)² + μ ε:ε up to third order.
    #[test]
    fn neo_hookean_is_linear_elastic_in_the_small() {
        let h = random_tensor::<3>(&mut Splitmix::new(3), 1e-5);
        let [linear, neo_hookean] = materials().map(|response| response.stress(&h).0);
        for i in 0..3 {
            (0..3).for_each(|j| assert!((linear[i][j] - neo_hookean[i][j]).abs() < 1e-8 * G));
        }
    }

    #[test]
    fn rotation_gives_no_stress_and_turns_stress() {
        let response = materials()[1];
        let mut random = Splitmix::new(4);
        for seed in 0..10 {
            let turn: Tensor<3> = random_rotation(seed);
            let identity = |i: usize, j: usize| f64::from(i == j);
            let (stress, energy) = response.stress::<3>(&from_fn(|i, j| turn[i][j] - identity(i, j)));
            assert!(energy.abs() < 1e-14 * G && stress.iter().flatten().all(|p| p.abs() < 1e-14 * G));
            // P(RF) = R P(F)
            let h = random_tensor::<3>(&mut random, 0.3);
            let turned =
                from_fn(|i, j| (0..3).map(|k| turn[i][k] * (identity(k, j) + h[k][j])).sum::<f64>() - identity(i, j));
            let (p, rp) = (response.stress(&h).0, response.stress::<3>(&turned).0);
            for i in 0..3 {
                for j in 0..3 {
                    let expected: f64 = (0..3).map(|k| turn[i][k] * p[k][j]).sum();
                    assert!((rp[i][j] - expected).abs() < 1e-13 * G);
                }
            }
        }
    }

    /// Dilation F = s I is pure volume: P = K (s³ − 1) s² I and σ = K (s³ − 1) I.
    #[test]
    fn dilation_meets_the_bulk_modulus() {
        let response = materials()[1];
        let (s, bulk) = (1.2f64, 100.0 / 1.2);
        let h = from_fn(|i, j| if i == j { s - 1.0 } else { 0.0 });
        let (stress, energy) = response.stress::<3>(&h);
        let cauchy = response.cauchy(&h);
        assert!((energy - 0.5 * bulk * (s.powi(3) - 1.0).powi(2)).abs() < 1e-13 * bulk);
        for i in 0..3 {
            assert!((stress[i][i] - bulk * (s.powi(3) - 1.0) * s * s).abs() < 1e-13 * bulk);
            assert!((cauchy[i][i] - bulk * (s.powi(3) - 1.0)).abs() < 1e-13 * bulk);
        }
    }

    #[test]
    fn inverted_material_has_infinite_energy() {
        let response = materials()[1];
        assert_eq!(response.stress::<2>(&[[-2.0, 0.0], [0.0, 0.0]]).1, f64::INFINITY);
        assert_eq!(response.stress::<3>(&[[0.0; 3], [0.0; 3], [0.0, 0.0, -1.5]]).1, f64::INFINITY);
    }
}
