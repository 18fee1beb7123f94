//! What a search for an equilibrium asks of its host, and what it is answered.

use crate::contact::tangents::TangentPart;

/// What the host is asked for. All vectors have one entry for every unknown of the host.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// Internal less external forces at a state, without contact: [`Answer::Forces`], or [`Answer::Refused`] where the bodies cannot be
    /// there. With `matrix` their derivative there is what later requests mean by K; without it the host may leave it out.
    Forces {
        /// The unknowns.
        x: Vec<f64>,
        /// Whether K is that of this state from now on.
        matrix: bool,
    },
    /// K v, rows and columns of unknowns that are not free included: [`Answer::Vector`].
    Product {
        /// The vector v.
        vector: Vec<f64>,
        /// Whether the entries of K are taken by their magnitudes.
        magnitudes: bool,
    },
    /// The diagonal of K: [`Answer::Vector`].
    Diagonal,
    /// The free unknowns of d, zero elsewhere, with (K + shift diag K + T) d = right in the free rows, where T is the contact's tangent:
    /// [`Answer::Vector`], or [`Answer::Refused`] where the matrix is singular.
    Solve {
        /// Where T is taken, which is where K was.
        x: Vec<f64>,
        /// Which part of T.
        part: TangentPart,
        /// Part of the diagonal of K that is added.
        shift: f64,
        /// The right side.
        right: Vec<f64>,
    },
    /// A step from x to the equilibrium of the contact as it is with bodies that are linear, K and the forces last given, while what is
    /// prescribed moves by `moved`: [`Answer::Step`], or [`Answer::Refused`] where there is none. Only of hosts that offer it.
    Condensed {
        /// Where the step begins.
        x: Vec<f64>,
        /// How unknowns that are not free move.
        moved: Vec<f64>,
        /// Internal less external forces at x.
        forces: Vec<f64>,
        /// Residual that may be left, by the forces.
        tolerance: f64,
        /// Residual that may be left, a force.
        absolute_tolerance: f64,
    },
}

/// An answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// Forces, and the energy whose derivative they are where the host knows one.
    Forces {
        /// Internal less external forces.
        forces: Vec<f64>,
        /// Strain energy less the work of loads.
        energy: Option<f64>,
    },
    /// A vector.
    Vector(Vec<f64>),
    /// A step.
    Step {
        /// Change of all unknowns.
        step: Vec<f64>,
        /// Whether K was found to be symmetric and positive definite where nothing touches.
        is_definite: bool,
    },
    /// What was asked for is not there, and why.
    Refused(String),
}
