//! Contact energy.

use super::penetration_law::{PenetrationLaw, check_positive};
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
        stiffness: f64,
        /// Exponent, at least 1.
        exponent: f64,
    },
    /// w = Σ ω ψ(L) over lines along the mean contact normal, with ω the measure across them for which each stands and
    /// L the length of its part inside both bodies: the penetration depth. The energy is local, and its traction ψ'(L)
    /// varies over the patch.
    Fiber(PenetrationLaw),
    /// w = k/2 ∫ (g_A + g_B) dx over the overlap, each body carrying the depth g of its material below its own surface;
    /// against an obstacle w = k ∫ g dx with the depth below its surface. Where flat surfaces overlap by δ the pressure
    /// is k δ on either, as with `Fiber`; but no direction is needed, and the energy has no step wherever corners, edges
    /// and whole bodies go. Bodies need cells where they meet one another, not where they meet obstacles. Obstacles that
    /// are curved, or not convex where a body reaches, by quadrature. Measured without lines under every estimator.
    Depth {
        /// Stiffness, positive, Pa/length.
        stiffness: f64,
    },
}

impl EnergyLaw {
    /// w = k V.
    pub fn volume(k: f64) -> Self {
        EnergyLaw::Volume { stiffness: k, exponent: 1.0 }
    }

    /// w = Σ ω ½ k L²: pressure = k × penetration, k in Pa/length.
    pub fn fiber(k: f64) -> Self {
        EnergyLaw::Fiber(PenetrationLaw::quadratic(k))
    }

    /// w = k/2 ∫ (g_A + g_B) dx: pressure = k × penetration, k in Pa/length.
    pub fn depth(k: f64) -> Self {
        EnergyLaw::Depth { stiffness: k }
    }

    /// k.
    pub fn stiffness(&self) -> f64 {
        match self {
            EnergyLaw::Volume { stiffness, .. } | EnergyLaw::Depth { stiffness } => *stiffness,
            EnergyLaw::Fiber(law) => law.stiffness,
        }
    }

    /// The same with this k.
    pub fn with_stiffness(mut self, k: f64) -> Self {
        let (EnergyLaw::Volume { stiffness, .. }
        | EnergyLaw::Fiber(PenetrationLaw { stiffness, .. })
        | EnergyLaw::Depth { stiffness }) = &mut self;
        *stiffness = k;
        self
    }

    /// Whether k is 0, which stands for the one that the stiffness of the bodies gives: see
    /// [`Contact::set_layer_stiffness`](crate::Contact::set_layer_stiffness).
    pub fn is_without_stiffness(&self) -> bool {
        self.stiffness() == 0.0
    }

    /// The same with another stiffness: k by a factor.
    pub fn stiffened(self, factor: f64) -> Self {
        self.with_stiffness(factor * self.stiffness())
    }

    /// Energy of `measure`: of the overlap volume V; for the fiber law ψ of a length L; for the depth law of a
    /// penetration between flat surfaces, by area.
    pub fn energy(&self, measure: f64) -> f64 {
        match *self {
            EnergyLaw::Volume { stiffness: k, exponent: m } => k * measure.max(0.0).powf(m),
            EnergyLaw::Fiber(law) => law.energy(measure),
            EnergyLaw::Depth { stiffness } => PenetrationLaw::quadratic(stiffness).energy(measure),
        }
    }

    /// Its first derivative: the traction. At 0 it is the one-sided limit, k for `Volume` with m = 1.
    pub fn energy_gradient(&self, measure: f64) -> f64 {
        match *self {
            EnergyLaw::Volume { stiffness: k, exponent: 1.0 } => k,
            EnergyLaw::Volume { stiffness: k, exponent: m } => k * m * measure.max(0.0).powf(m - 1.0),
            EnergyLaw::Fiber(law) => law.energy_gradient(measure),
            EnergyLaw::Depth { stiffness } => PenetrationLaw::quadratic(stiffness).energy_gradient(measure),
        }
    }

    /// Its second derivative; at 0 the one-sided limit, infinite for `Volume` with 1 < m < 2.
    pub fn energy_hessian(&self, measure: f64) -> f64 {
        match *self {
            EnergyLaw::Volume { exponent: 1.0, .. } => 0.0,
            EnergyLaw::Volume { stiffness: k, exponent: m } => k * m * (m - 1.0) * measure.max(0.0).powf(m - 2.0),
            EnergyLaw::Fiber(law) => law.energy_hessian(measure),
            EnergyLaw::Depth { stiffness } => stiffness,
        }
    }

    /// Whether the energy is taken line by line.
    pub fn is_fiber(&self) -> bool {
        matches!(self, EnergyLaw::Fiber(_))
    }

    /// Whether it asks how deep the cells of bodies lie below their surfaces.
    pub(crate) fn needs_depth(&self) -> bool {
        matches!(self, EnergyLaw::Depth { .. })
    }

    /// Checks that k is positive and finite, m finite and at least 1, ε positive and finite. An error names the option
    /// as the user sets it, `stiffness` for k and `exponent` for m.
    pub(crate) fn check(&self) -> Result<(), Error> {
        match *self {
            EnergyLaw::Volume { stiffness, exponent } if exponent.is_finite() && exponent >= 1.0 => {
                check_positive("stiffness", stiffness)
            }
            EnergyLaw::Volume { stiffness, exponent } => check_positive("stiffness", stiffness)
                .and(Err(Error::NotPositive { name: "exponent", value: exponent })),
            EnergyLaw::Fiber(law) => law.check(),
            EnergyLaw::Depth { stiffness } => check_positive("stiffness", stiffness),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::laws::EnergyProfile;

    #[test]
    fn derivatives_are_those_of_the_energy() {
        let linear = EnergyProfile::Linear { smoothing_length: 1e-2 };
        for law in [
            EnergyLaw::Volume { stiffness: 3.0, exponent: 2.0 },
            EnergyLaw::Volume { stiffness: 3.0, exponent: 1.5 },
            EnergyLaw::volume(3.0),
            EnergyLaw::fiber(3.0),
            EnergyLaw::depth(3.0),
            EnergyLaw::Fiber(PenetrationLaw { stiffness: 3.0, profile: linear }),
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
