//! Friction with another coefficient along a direction of a surface than across it.

use super::options::{Friction, StaticFriction};
use crate::Error;

/// Friction of a pair that has its coefficient along a direction only, as a surface with machining marks, a grain or fibres.
///
/// Tractions t lie in the ellipse √((t₁/μ₁)² + (t₂/μ₂)²) ≤ p, t₁ being along the direction and t₂ across it, both in the tangent plane.
/// Slip is that which dissipates most: normal to the ellipse. So the force on a body that slides at an angle is not opposite to its way.
///
/// μ₁ is the pair's coefficient of friction. With friction at rest both limits are larger by the same factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrthotropicFriction {
    /// Coefficient μ₂ across the direction, at least 0 and finite.
    pub transverse_coefficient: f64,
    /// The direction, of any length but 0 and of either sign: that of a body without deformation, that of an obstacle in its own frame.
    ///
    /// It is projected into the plane of each facet there, and goes along as the facet deforms and turns. A facet to which it is
    /// perpendicular, up to 0.06°, has no such direction: all slip is across it, and the coefficient is μ₂.
    pub direction: [f64; 3],
    /// Whether it belongs to the second of the two partners, in the order in which the pair is named; else to the first.
    pub of_second: bool,
}

impl OrthotropicFriction {
    /// A coefficient across a direction of the partner that is named first.
    pub fn new(transverse_coefficient: f64, direction: [f64; 3]) -> Self {
        Self { transverse_coefficient, direction, of_second: false }
    }

    /// Of the same pair with its partners in the other order.
    pub(crate) fn swapped(self) -> Self {
        Self { of_second: !self.of_second, ..self }
    }

    /// What slides most beside this friction: that in the direction of the larger coefficient.
    pub(crate) fn largest(&self, along: Friction) -> Friction {
        let largest = along.coefficient.max(self.transverse_coefficient);
        // With no coefficient along there is none from rest to go by, which is refused.
        let factor = if along.coefficient > 0.0 { largest / along.coefficient } else { 1.0 };
        let at_rest = along.at_rest.map(|own| StaticFriction { coefficient: own.coefficient * factor, ..own });
        Friction { coefficient: largest, at_rest, ..along }
    }

    /// The same by its shape, beside this friction.
    pub(crate) fn shape(&self, along: Friction) -> Orthotropy {
        let largest = along.coefficient.max(self.transverse_coefficient);
        let length = self.direction.iter().fold(0.0, |sum: f64, x| sum.hypot(*x));
        Orthotropy {
            direction: self.direction.map(|x| x / length),
            of_second: self.of_second,
            factors: [along.coefficient, self.transverse_coefficient].map(|mu| mu / largest),
        }
    }

    /// Checks every value, beside the friction along the direction.
    pub(crate) fn check(&self, along: &Friction) -> Result<(), Error> {
        let value = self.transverse_coefficient;
        if !(value.is_finite() && value >= 0.0) {
            return Err(Error::NotPositive { name: "transverse_coefficient", value });
        }
        if let Some((entry, &value)) = self.direction.iter().enumerate().find(|(_, x)| !x.is_finite()) {
            return Err(Error::BadEntry { array: "direction", entry, value });
        }
        let length = self.direction.iter().fold(0.0, |sum: f64, x| sum.hypot(*x));
        if !(length.is_finite() && length > 0.0) {
            return Err(Error::NotPositive { name: "length of direction", value: length });
        }
        let what = if along.coefficient.is_infinite() {
            "a transverse_coefficient with an infinite coefficient of friction"
        } else if along.cohesion != 0.0 || along.shear_limit.is_finite() {
            "a transverse_coefficient with a cohesion or a shear limit, which have no direction"
        } else if along.at_rest.is_some() && along.coefficient == 0.0 {
            "a transverse_coefficient with a static_coefficient and no friction_coefficient, to which both are in proportion"
        } else {
            return Ok(());
        };
        Err(Error::Unsupported { what })
    }
}

/// A direction, and limits by the larger of both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Orthotropy {
    /// Unit vector.
    pub(crate) direction: [f64; 3],
    pub(crate) of_second: bool,
    /// Along it and across.
    pub(crate) factors: [f64; 2],
}
