//! Materials.

/// Constitutive law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Hooke's law of small strains, linear also in its kinematics:
    /// W = λ/2 (tr ε)² + μ ε:ε with ε = (H + Hᵀ)/2, P = λ tr ε I + 2μ ε.
    LinearElastic,
    /// The same in plane stress: a plate, per unit thickness, with σ_zz = 0 and so λ′ = 2λμ/(λ + 2μ) in the place of λ.
    PlaneStress,
    /// Compressible neo-Hookean solid: W = G/2 (J^(−2/3) I₁ − 3) + K/2 (J − 1)² with F = I + H, J = det F and
    /// I₁ = tr FᵀF (Wang, Xu and Xue, section 4.2.2). In plane strain F_zz = 1, which adds 1 to I₁.
    NeoHookean,
}

/// Law and constants of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Constitutive law.
    pub law: Law,
    /// Young's modulus E, positive, in Pa.
    pub young: f64,
    /// Poisson's ratio ν, between −1 and ½.
    pub poisson: f64,
    /// Density ρ of the undeformed body, positive, in kg/m³.
    pub density: f64,
}

impl Material {
    /// Shear modulus G = μ = E / 2(1 + ν).
    pub fn shear_modulus(&self) -> f64 {
        self.young / (2.0 * (1.0 + self.poisson))
    }

    /// Bulk modulus K = E / 3(1 − 2ν).
    pub fn bulk_modulus(&self) -> f64 {
        self.young / (3.0 * (1.0 - 2.0 * self.poisson))
    }

    /// Lamé's λ = E ν / (1 + ν)(1 − 2ν).
    pub fn lame(&self) -> f64 {
        self.young * self.poisson / ((1.0 + self.poisson) * (1.0 - 2.0 * self.poisson))
    }

    /// Speed of pressure waves in the undeformed body, √((λ + 2μ)/ρ).
    pub fn wave_speed(&self) -> f64 {
        ((self.lame() + 2.0 * self.shear_modulus()) / self.density).sqrt()
    }

    /// The first constant out of its range: name, value and range.
    pub(super) fn flaw(&self) -> Option<(&'static str, f64, &'static str)> {
        let positive = |x: f64| x > 0.0 && x.is_finite();
        if !positive(self.young) {
            Some(("Young's modulus", self.young, "positive"))
        } else if !(self.poisson > -1.0 && self.poisson < 0.5) {
            Some(("Poisson's ratio", self.poisson, "between -1 and 0.5"))
        } else if !positive(self.density) {
            Some(("density", self.density, "positive"))
        } else {
            None
        }
    }
}
