//! What resists sliding.

use crate::Error;

/// Coulomb friction with a stiff, reversible stick.
///
/// Points that face one another stick as long as the traction k_T s stays below its limit τ, s being the elastic slip, and
/// slide at the limit τ = min(μ p + cohesion, shear limit) against their slip, p being the pressure there. The default is
/// no friction.
///
/// Without memory, by `memoryless_slip` ε, the traction is τ (2 y − y²) below y = s/ε = 1 and τ beyond, s being the slip of
/// the step alone: smooth, and nothing is carried from one step to the next, so that what should stick creeps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Coefficient of friction μ, at least 0; of what slides, where there is another for what rests. Infinite: nothing slides where it
    /// presses, but by the shear limit; not without memory.
    pub coefficient: f64,
    /// Coefficient from rest, and how it falls; `None`: one coefficient. Not together with `memoryless_slip`.
    pub at_rest: Option<StaticFriction>,
    /// Tangential stiffness k_T of the stick, positive, Pa/length; `None`: the stiffness of the energy law at a first
    /// touch, k.
    pub stiffness: Option<f64>,
    /// Slip ε of a step, positive, from which on friction without memory acts in full: a speed times the time step, say.
    /// `None`: friction with memory. Not together with `stiffness`.
    pub memoryless_slip: Option<f64>,
    /// Traction that is transmitted without pressure wherever there is contact, at least 0, Pa.
    pub cohesion: f64,
    /// Largest traction, positive, Pa; infinite: no limit.
    pub shear_limit: f64,
}

/// Friction of what rests, and begins to slide. A facet that sticks throughout a step rests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticFriction {
    /// Coefficient, at least that of what slides.
    pub coefficient: f64,
    /// Slip over which it falls to that of what slides, in proportion; positive, a length.
    pub weakening_slip: f64,
}

impl Default for Friction {
    fn default() -> Self {
        Self {
            coefficient: 0.0,
            at_rest: None,
            stiffness: None,
            memoryless_slip: None,
            cohesion: 0.0,
            shear_limit: f64::INFINITY,
        }
    }
}

impl Friction {
    /// Friction with this coefficient.
    pub fn coulomb(coefficient: f64) -> Self {
        Self { coefficient, ..Self::default() }
    }

    /// Whether there is any.
    pub fn is_active(&self) -> bool {
        self.largest_coefficient() > 0.0 || self.cohesion > 0.0
    }

    /// That from rest.
    pub(crate) fn largest_coefficient(&self) -> f64 {
        self.at_rest.map_or(self.coefficient, |at_rest| at_rest.coefficient)
    }

    /// Coefficient of a facet that has slid so far since it rested.
    pub(crate) fn coefficient_after(&self, slid: f64) -> f64 {
        self.at_rest.map_or(self.coefficient, |StaticFriction { coefficient, weakening_slip }| {
            self.coefficient + (coefficient - self.coefficient) * (1.0 - slid / weakening_slip).max(0.0)
        })
    }

    /// Whether the stick is as stiff as the law: elastic slip that is carried then pulls with the stiffness of now.
    pub(crate) fn has_stiffness_of_law(&self) -> bool {
        self.stiffness.is_none()
    }

    /// Checks every value.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let refuse = |name, value: f64| Err(Error::NotPositive { name, value });
        if self.coefficient.is_nan() || self.coefficient < 0.0 {
            return refuse("friction_coefficient", self.coefficient);
        }
        if !(self.cohesion.is_finite() && self.cohesion >= 0.0) {
            return refuse("cohesion", self.cohesion);
        }
        if self.coefficient.is_infinite() && self.memoryless_slip.is_some() {
            let what = "an infinite coefficient with friction without memory, which creeps: leave memoryless_slip at \
                its default";
            return Err(Error::Unsupported { what });
        }
        for (name, value) in [("friction_stiffness", self.stiffness), ("memoryless_slip", self.memoryless_slip)] {
            if let Some(value) = value.filter(|value| !(value.is_finite() && *value > 0.0)) {
                return refuse(name, value);
            }
        }
        if let Some(StaticFriction { coefficient, weakening_slip }) = self.at_rest {
            if !(coefficient.is_finite() && coefficient >= 0.0) {
                return refuse("static_coefficient", coefficient);
            }
            if coefficient < self.coefficient {
                let what = "a static_coefficient below friction_coefficient, to which it would have to rise";
                return Err(Error::Unsupported { what });
            }
            if !(weakening_slip.is_finite() && weakening_slip > 0.0) {
                return refuse("weakening_slip", weakening_slip);
            }
            if self.memoryless_slip.is_some() {
                let what = "a static coefficient with friction without memory, which cannot tell sticking facets: \
                    leave one of static_coefficient and memoryless_slip at its default";
                return Err(Error::Unsupported { what });
            }
        }
        if self.stiffness.is_some() && self.memoryless_slip.is_some() {
            let what = "a stiffness of the stick with friction without memory, which has none: leave one of \
                        friction_stiffness and memoryless_slip at its default";
            return Err(Error::Unsupported { what });
        }
        if self.shear_limit.is_nan() || self.shear_limit <= 0.0 {
            return refuse("shear_limit", self.shear_limit);
        }
        Ok(())
    }
}
