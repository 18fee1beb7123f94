//! How an equilibrium is sought.

/// Largest residual by the forces that a program should take as a tolerance: Abaqus takes half of it where nothing else is wanted.
pub const LARGEST_TOLERANCE: f64 = 0.01;

/// How an equilibrium is sought: the rest is up to the library's search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NewtonSettings {
    /// Residual by the forces at which a state counts as balanced.
    pub tolerance: f64,
    /// Iterations of one load step, at most: linear systems solved.
    pub most_iterations: usize,
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
    /// That of now: the matrix is not symmetric, and the end is quadratic. Where that leads nowhere, that of an earlier iterate.
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
            most_turns: 8,
            penetration: 0.0,
            most_updates: 20,
            friction: FrictionPressure::default(),
        }
    }
}
