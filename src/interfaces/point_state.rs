//! What a point of a cohesive interface carries from one step to the next.

use crate::Error;

/// How far a point of a cohesive interface is broken.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointDamage {
    /// 0: whole, 1: broken. It never falls.
    pub damage: f64,
    /// Energy by area that the point has dissipated as it broke, without what viscosity and friction took.
    pub dissipated: f64,
}

/// What else a point of a cohesive interface has been through: friction of its broken part, the viscosity of its damage, and what the law
/// ppr has beside damage. All zero without these.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointHistory {
    /// How far the broken part has slid without elastic slip, in multiples of the edges of the facet of the second body that leave its first
    /// corner; in 2D the second is 0. So it turns and stretches with the facet.
    pub slip: [f64; 2],
    /// Energy by area that friction has dissipated.
    pub rubbed: f64,
    /// Energy by area that the viscosity has dissipated.
    pub viscous: f64,
    /// Where the point was when the step began, √(Y/Y₀): more than its damage says while viscosity holds damage back; else 0.
    /// By the law [`Ppr`](super::Ppr) the smaller of the largest opening and sliding, each by that at which its traction ends; plus 2 where it
    /// is the opening.
    pub reached: f64,
}

impl PointHistory {
    /// The numbers in this order.
    pub(crate) const COUNT: usize = 5;

    pub(crate) fn numbers(&self) -> [f64; Self::COUNT] {
        let Self { slip, rubbed, viscous, reached } = *self;
        [slip[0], slip[1], rubbed, viscous, reached]
    }

    pub(crate) fn of_numbers([first, second, rubbed, viscous, reached]: [f64; Self::COUNT]) -> Self {
        Self { slip: [first, second], rubbed, viscous, reached }
    }

    /// Refuses what cannot be. What friction took may be below 0 by what its stick stores in area that has just broken.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let names = ["slip", "slip", "rubbed", "viscous", "reached"];
        for (name, value) in names.into_iter().zip(self.numbers()) {
            if !value.is_finite() {
                return Err(Error::NotPositive { name, value });
            }
        }
        Error::check_not_negative("viscous", self.viscous)?;
        Error::check_not_negative("reached", self.reached)
    }
}

/// Both.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PointState {
    pub(crate) damage: PointDamage,
    pub(crate) history: PointHistory,
}

/// What a point does at an opening and a sliding.
#[derive(Clone, Copy)]
pub(super) struct Response {
    pub(super) now: PointState,
    /// Energy by area that unloading would give back.
    pub(super) stored: f64,
    /// Traction along the normal, negative in compression, and its derivative at this damage.
    pub(super) normal: f64,
    pub(super) normal_stiffness: f64,
    /// Traction by sliding.
    pub(super) shear_stiffness: f64,
    /// How the damage grows: by dY, and by the part of it that is sliding's.
    pub(super) growth: Option<[f64; 2]>,
    /// What else the derivative of the tractions has, as the law ppr has it: ∂t_n/∂δ_n less the stiffness at this damage, ∂t_n/∂|δ_t| by |δ_t|, and of
    /// the traction by sliding ∂/∂δ_n and ∂/∂|δ_t| by |δ_t|.
    pub(super) coupled: Option<[f64; 4]>,
}
