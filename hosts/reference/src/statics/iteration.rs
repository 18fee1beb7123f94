//! What a solver reports of its iterations.

use super::balance::Balance;
use std::fmt;

/// One iteration: the state it starts from, and what it did then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Iteration {
    /// Part of the full load.
    pub load: f64,
    /// Number within this load, from 0.
    pub iteration: usize,
    /// Residual on what is not held, by the largest of the forces' norms.
    pub residual: f64,
    /// Total energy.
    pub energy: f64,
    /// Facets in contact.
    pub facets: usize,
    /// Largest penetration, length.
    pub penetration: f64,
    /// Matrix of the step that followed; `None` where none was needed any more.
    pub tangent: Option<Tangent>,
    /// Part of the step that the line search took.
    pub length: f64,
    /// Iterations of the contact, with the bodies linear, that the step took.
    pub contact_iterations: usize,
}

/// Matrix of an iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tangent {
    /// Second derivative of the energy.
    Full,
    /// Without the part of the contact that can be negative.
    Semidefinite,
    /// Of the bodies alone.
    Elastic,
    /// Of the bodies; contact as it is, by iterations of its own.
    Contact,
}

impl Iteration {
    /// The state of which `balance` is, before anything is done.
    pub(super) fn at<const D: usize>(balance: &Balance<D>, load: f64, iteration: usize) -> Self {
        Self {
            load,
            iteration,
            residual: balance.relative(),
            energy: balance.energy(),
            facets: balance.contact.facet_count,
            penetration: balance.contact.penetration,
            tangent: None,
            length: 0.0,
            contact_iterations: 0,
        }
    }
}

impl fmt::Display for Tangent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Tangent::Full => "full",
            Tangent::Semidefinite => "semidefinite",
            Tangent::Elastic => "elastic",
            Tangent::Contact => "contact",
        })
    }
}

impl fmt::Display for Iteration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { load, iteration, residual, energy, facets, penetration, tangent, length, contact_iterations } = self;
        write!(
            f,
            "load {load:<6.4} iteration {iteration:>3}  residual {residual:.3e}  energy {energy:+.9e}  \
             facets {facets:>5}  penetration {penetration:.3e}"
        )?;
        match tangent {
            None => Ok(()),
            Some(Tangent::Contact) => write!(f, "  contact, {contact_iterations} iterations × {length:.3}"),
            Some(tangent) => write!(f, "  {tangent} × {length:.3}"),
        }
    }
}
