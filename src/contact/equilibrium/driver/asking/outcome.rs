//! What a search has led to.

use super::trouble::{Trouble, Unheld};
use crate::Error;
use crate::contact::results::ContactForces;

/// How the equilibrium was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// By steps to the equilibrium of the contact with linear bodies.
    Condensed,
    /// By whole steps of Newton's method: it is the one beside the start.
    Nearest,
    /// Down the energy.
    Downhill,
}

/// An equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct Found<const D: usize> {
    /// The unknowns.
    pub x: Vec<f64>,
    /// Contact there.
    pub contact: ContactForces<D>,
    /// Internal less external less contact forces: at unknowns that are not free, what holds them.
    pub reactions: Vec<f64>,
    /// How it was found.
    pub way: Way,
    /// Linear systems solved, without those that tell whether loose bodies stand.
    pub solves: usize,
    /// Rigid steps in which loose bodies came to rest.
    pub rigid_steps: usize,
    /// Parts in which the step was made.
    pub parts: usize,
    /// Rigid motions that the host's matrix does not hold, or hardly.
    pub loose_count: usize,
    /// Pairs of which friction counts the slip from where they first touched, and not from the start of the step.
    pub first_touches: usize,
    /// Updates of the multipliers.
    pub updates: usize,
    /// Largest mean penetration of a node, where that was measured.
    pub penetration: Option<f64>,
    /// Residual by the forces, state by state.
    pub residuals: Vec<f64>,
    /// How bodies may move that nothing holds there; [`Self::warnings`] has a sentence for each.
    pub free: Vec<Unheld>,
    /// What the user should know.
    pub warnings: Vec<String>,
}

/// No equilibrium, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// A sentence.
    pub text: String,
    /// The body that nothing holds, where that is why.
    pub unheld: Option<Unheld>,
    /// What the contact could not evaluate, where that is why.
    pub error: Option<Error>,
    /// Residual by the forces, state by state.
    pub residuals: Vec<f64>,
    /// Linear systems solved.
    pub solves: usize,
}

impl Refusal {
    pub(crate) fn new(trouble: Trouble, residuals: Vec<f64>, solves: usize) -> Self {
        let text = trouble.to_string();
        let (unheld, error) = match trouble {
            Trouble::Unheld(unheld, _) | Trouble::Adrift(unheld, _) => (Some(unheld), None),
            Trouble::Contact(error) => (None, Some(error)),
            Trouble::Host(_) | Trouble::Failed(_) | Trouble::Hopeless(_) => (None, None),
        };
        Self { text, unheld, error, residuals, solves }
    }

    /// Of a search that its host gives up.
    pub(crate) fn abandoned() -> Self {
        let text = "the host has abandoned the search".to_owned();
        Self { text, unheld: None, error: None, residuals: Vec::new(), solves: 0 }
    }
}
