//! How Newton's method is led.

/// How Newton's method is led.
///
/// The energy of the fiber law is not convex where lines meet inclined flanks, and the full tangent may lead astray far
/// from the solution. So the matrix is semidefinite in its contact part until the residual is below `full_below`, and
/// full then, in the iterations of the contact alone as in those of everything at once, which are made where the former
/// cannot be; back for one step if a full one does not halve the residual, or if the full matrix is not positive definite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NewtonSettings {
    /// Residual by the forces at which a state counts as balanced.
    pub tolerance: f64,
    /// Iterations of one load step, at most.
    pub most_iterations: usize,
    /// Residual by the forces below which the full tangent is used.
    pub full_below: f64,
    /// Times, at most, that the patches of the fiber law are found anew at the end of a path; three or four mostly do, seven where few facets touch.
    pub most_turns: usize,
    /// Largest mean penetration of a node that is wanted, a length; 0: that of the law, as it is. Surfaces are then moved out until
    /// they press without ([`Contact::augment`](fmc_contact::Contact::augment)), at every load step. Where an update leaves more
    /// than a quarter, the law's stiffness is raised fourfold, sixteenfold at most, and stays so.
    pub penetration: f64,
    /// Updates of these multipliers in a load step, at most.
    pub most_updates: usize,
    /// Which pressure friction has, where there is friction.
    pub friction: FrictionPressure,
}

/// By which pressure the limit of friction is set during a solve. Both lead to the same equilibrium.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FrictionPressure {
    /// `Lagged` until the residual is below [`NewtonSettings::full_below`], and that of now then: the matrix is not
    /// symmetric, a step is shortened until the residual falls, and the end is quadratic. Where that leads nowhere,
    /// `Lagged` goes on.
    #[default]
    Current,
    /// That of an earlier iterate, until it is that of now: every solve has an energy, and leads there from afar. Each
    /// takes some tenth of the error that the one before has left.
    Lagged,
}

impl Default for NewtonSettings {
    fn default() -> Self {
        Self {
            tolerance: 1e-10,
            most_iterations: 60,
            full_below: 0.1,
            most_turns: 8,
            penetration: 0.0,
            most_updates: 20,
            friction: FrictionPressure::default(),
        }
    }
}
