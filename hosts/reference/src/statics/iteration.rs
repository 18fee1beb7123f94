//! What a solver tells of its way.

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
}

impl fmt::Display for Tangent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Tangent::Full => "full",
            Tangent::Semidefinite => "semidefinite",
            Tangent::Elastic => "elastic",
        })
    }
}

impl fmt::Display for Iteration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { load, iteration, residual, energy, facets, penetration, tangent, length } = self;
        write!(
            f,
            "load {load:<6.4} iteration {iteration:>3}  residual {residual:.3e}  energy {energy:+.9e}  \
             facets {facets:>5}  penetration {penetration:.3e}"
        )?;
        tangent.map_or(Ok(()), |tangent| write!(f, "  {tangent} × {length:.3}"))
    }
}
