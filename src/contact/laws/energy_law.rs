//! Contact energy.

use crate::Error;

/// Contact energy w of one overlapping pair; nodal forces are −∂w/∂x.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum EnergyLaw {
    /// w = k Vᵐ (paper, Eq. for w(V_c)); m = 1 is the paper's choice.
    ///
    /// With m = 1 the traction is k wherever there is overlap: k is a pressure, and must exceed the peak contact
    /// pressure or the bodies pass through one another. In general the traction is k m Vᵐ⁻¹, one number per pair.
    /// Units: energy / (length^D)ᵐ, in 2D per unit thickness; for m = 1 that is Pa in both dimensions, for m = 2 it is
    /// Pa/m² in 2D and Pa/m³ in 3D.
    Volume {
        /// Stiffness, positive.
        k: f64,
        /// Exponent, at least 1.
        m: f64,
    },
    /// w = Σ ω ψ(L) over lines along the mean contact normal, with ω the measure across them for which each stands and
    /// L the length of its part inside both bodies: the penetration depth. The energy is local, and its traction ψ'(L)
    /// varies over the patch.
    Fiber {
        /// Stiffness, positive: Pa/length for [`FiberProfile::Quadratic`], Pa for [`FiberProfile::Linear`].
        k: f64,
        /// ψ.
        profile: FiberProfile,
    },
}

/// Energy ψ of one line, per measure across it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum FiberProfile {
    /// ψ = ½ k L²: the pressure is k times the penetration. Smooth (C¹) where contact begins.
    Quadratic,
    /// ψ = k (√(L² + ε²) − ε): for ε → 0 the paper's m = 1, pressure k wherever there is overlap; smooth for ε > 0.
    Linear {
        /// Smoothing length ε > 0, over which the pressure grows to k.
        epsilon: f64,
    },
}

impl EnergyLaw {
    /// w = k V.
    pub fn volume(k: f64) -> Self {
        EnergyLaw::Volume { k, m: 1.0 }
    }

    /// w = Σ ω ½ k L²: pressure = k × penetration, k in Pa/length.
    pub fn fiber(k: f64) -> Self {
        EnergyLaw::Fiber { k, profile: FiberProfile::Quadratic }
    }

    /// Energy of `measure`: of the overlap volume V, or, for the fiber law, ψ of a length L.
    pub fn energy(&self, measure: f64) -> f64 {
        let x = measure.max(0.0);
        match *self {
            EnergyLaw::Volume { k, m } => k * x.powf(m),
            EnergyLaw::Fiber { k, profile: FiberProfile::Quadratic } => 0.5 * k * x * x,
            // √(L² + ε²) − ε without cancellation.
            EnergyLaw::Fiber { k, profile: FiberProfile::Linear { epsilon } } => {
                k * x * (x / (x.hypot(epsilon) + epsilon))
            }
        }
    }

    /// Its first derivative: the traction. At 0 it is the one-sided limit, k for `Volume` with m = 1.
    pub fn energy_gradient(&self, measure: f64) -> f64 {
        let x = measure.max(0.0);
        match *self {
            EnergyLaw::Volume { k, m: 1.0 } => k,
            EnergyLaw::Volume { k, m } => k * m * x.powf(m - 1.0),
            EnergyLaw::Fiber { k, profile: FiberProfile::Quadratic } => k * x,
            EnergyLaw::Fiber { k, profile: FiberProfile::Linear { epsilon } } => k * (x / x.hypot(epsilon)),
        }
    }

    /// Its second derivative; at 0 the one-sided limit, infinite for `Volume` with 1 < m < 2.
    pub fn energy_hessian(&self, measure: f64) -> f64 {
        let x = measure.max(0.0);
        match *self {
            EnergyLaw::Volume { m: 1.0, .. } => 0.0,
            EnergyLaw::Volume { k, m } => k * m * (m - 1.0) * x.powf(m - 2.0),
            EnergyLaw::Fiber { k, profile: FiberProfile::Quadratic } => k,
            EnergyLaw::Fiber { k, profile: FiberProfile::Linear { epsilon } } => {
                let r = x.hypot(epsilon);
                k * (epsilon / r) * (epsilon / r) / r
            }
        }
    }

    /// Whether the energy is taken line by line.
    pub fn is_fiber(&self) -> bool {
        matches!(self, EnergyLaw::Fiber { .. })
    }

    /// Checks that k is positive and finite, m finite and at least 1, ε positive and finite. An error names the option
    /// as the user sets it, `stiffness` for k and `exponent` for m.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let positive = |name, value: f64, least: f64| {
            if value.is_finite() && value > 0.0 && value >= least {
                Ok(())
            } else {
                Err(Error::NotPositive { name, value })
            }
        };
        match *self {
            EnergyLaw::Volume { k, m } => positive("stiffness", k, 0.0).and(positive("exponent", m, 1.0)),
            EnergyLaw::Fiber { k, profile: FiberProfile::Quadratic } => positive("stiffness", k, 0.0),
            EnergyLaw::Fiber { k, profile: FiberProfile::Linear { epsilon } } => {
                positive("stiffness", k, 0.0).and(positive("epsilon", epsilon, 0.0))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_the_energy() {
        let linear = FiberProfile::Linear { epsilon: 1e-2 };
        for law in [
            EnergyLaw::Volume { k: 3.0, m: 2.0 },
            EnergyLaw::Volume { k: 3.0, m: 1.5 },
            EnergyLaw::volume(3.0),
            EnergyLaw::fiber(3.0),
            EnergyLaw::Fiber { k: 3.0, profile: linear },
        ] {
            for x in [1e-3, 0.02, 0.7] {
                // Central differences: truncation (h/x)² and rounding 1e-16 x/h.
                let h = 1e-5 * x;
                let slope = (law.energy(x + h) - law.energy(x - h)) / (2.0 * h);
                assert!((slope / law.energy_gradient(x) - 1.0).abs() < 1e-8, "{law:?} at {x}");
                let curvature = (law.energy_gradient(x + h) - law.energy_gradient(x - h)) / (2.0 * h);
                assert!(
                    (curvature - law.energy_hessian(x)).abs() < 1e-7 * law.energy_gradient(x) / x,
                    "{law:?} at {x}"
                );
            }
        }
    }
}
