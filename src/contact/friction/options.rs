//! What resists sliding.

use crate::Error;

/// Coulomb friction with a stiff, reversible stick.
///
/// Points that face one another stick as long as the traction k_T s stays below its limit, s being the elastic slip, and
/// slide at the limit min(μ p + cohesion, shear limit) against their slip, p being the pressure there. The default is no
/// friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Coefficient of friction μ, at least 0.
    pub coefficient: f64,
    /// Tangential stiffness k_T of the stick, positive, Pa/length; `None`: the stiffness of the energy law at a first
    /// touch, k.
    pub stiffness: Option<f64>,
    /// Traction that is transmitted without pressure wherever there is contact, at least 0, Pa.
    pub cohesion: f64,
    /// Largest traction, positive, Pa; infinite: no limit.
    pub shear_limit: f64,
}

impl Default for Friction {
    fn default() -> Self {
        Self { coefficient: 0.0, stiffness: None, cohesion: 0.0, shear_limit: f64::INFINITY }
    }
}

impl Friction {
    /// Friction with this coefficient.
    pub fn coulomb(coefficient: f64) -> Self {
        Self { coefficient, ..Self::default() }
    }

    /// Whether there is any.
    pub fn is_active(&self) -> bool {
        self.coefficient > 0.0 || self.cohesion > 0.0
    }

    /// Checks every value.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let refuse = |name, value: f64| Err(Error::NotPositive { name, value });
        for (name, value) in [("friction_coefficient", self.coefficient), ("cohesion", self.cohesion)] {
            if !(value.is_finite() && value >= 0.0) {
                return refuse(name, value);
            }
        }
        if let Some(stiffness) = self.stiffness
            && !(stiffness.is_finite() && stiffness > 0.0)
        {
            return refuse("friction_stiffness", stiffness);
        }
        if self.shear_limit.is_nan() || self.shear_limit <= 0.0 {
            return refuse("shear_limit", self.shear_limit);
        }
        Ok(())
    }
}
