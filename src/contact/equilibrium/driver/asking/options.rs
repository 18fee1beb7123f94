//! What a search is asked for.

use crate::Error;

/// When a search ends, and how. The default chooses everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriverOptions {
    /// Residual at free unknowns, by the forces of the bodies or of the contact, whichever are larger, in the Euclidean norm.
    pub tolerance: f64,
    /// Linear solves, at most.
    pub max_solves: usize,
    /// Whether the host answers [`Request::Condensed`](super::Request::Condensed).
    pub is_condensed: bool,
    /// Whether such steps are the first way also for bodies that springs hardly hold. They lead to an equilibrium that is stable, and that may
    /// be far from the start.
    pub is_condensed_first: bool,
    /// Whether they are that for bodies that only contact holds, too: the host condenses these on what touches.
    pub is_condensed_on_contact: bool,
    /// Largest mean penetration of a node that is wanted, a length; 0: a thousandth of the largest elastic displacement, where the
    /// stiffness was found by the search, and what the law leaves where it was given.
    pub penetration: f64,
    /// How far from a partner gaps are measured for it, a length; 0: a twentieth of the bodies' extent.
    pub reach: f64,
    /// Updates of multipliers, at most; that a penetration asked for needs more is an error.
    pub max_updates: usize,
    /// Whether patches of the law `fiber` are kept at the start, follow the contact far from its equilibrium, and are found again near
    /// it. Otherwise they are left to the host.
    pub finds_patches: bool,
    /// Whether the host is checked at the start, and nothing is solved: the residual beside the matrix, signs, symmetry, rigid motions.
    /// [`Found::warnings`](super::Found::warnings) has then a sentence for each.
    pub is_check: bool,
    /// Whether friction is frozen, solved for, and frozen again, all the way.
    pub is_lagged: bool,
    /// Whether all slip counts straight from the start of the step, also of pairs that touch later: derivatives of the equilibrium then hold no
    /// place of first touch.
    pub is_slip_straight: bool,
}

impl Default for DriverOptions {
    fn default() -> Self {
        Self {
            tolerance: 1e-9,
            max_solves: 100,
            is_condensed: false,
            is_condensed_first: false,
            is_condensed_on_contact: false,
            penetration: 0.0,
            reach: 0.0,
            max_updates: 20,
            finds_patches: false,
            is_check: false,
            is_lagged: false,
            is_slip_straight: false,
        }
    }
}

impl DriverOptions {
    pub(crate) fn check(&self) -> Result<(), Error> {
        let check = |name, value: f64, least: f64| match value.is_finite() && value >= least {
            true => Ok(()),
            false => Err(Error::NotPositive { name, value }),
        };
        check("tolerance", self.tolerance, f64::MIN_POSITIVE)?;
        check("max_solves", self.max_solves as f64, 1.0)?;
        check("reach", self.reach, 0.0)?;
        check("penetration", self.penetration, 0.0)
    }
}
