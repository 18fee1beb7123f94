//! Why there is no equilibrium, or none was found.

use std::fmt;

/// What stops a solver. The last converged state is kept.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum StaticsError {
    /// The residual did not become small enough.
    NotConverged {
        /// Part of the full load.
        load: f64,
        /// Iterations made.
        iterations: usize,
        /// Residual by the forces.
        residual: f64,
        /// What was in the way.
        why: String,
    },
    /// Neither supports nor contact hold a body.
    Unsupported {
        /// Its name.
        body: String,
        /// How it can move, as in "translation along x".
        motion: String,
    },
    /// The load drives a body on: away from all others, or along them.
    Adrift {
        /// Its name.
        body: String,
        /// How it moves.
        motion: String,
        /// Whether it may be held by friction.
        has_friction: bool,
    },
    /// With the linear law the pressure cannot exceed the stiffness: the bodies pass through one another.
    PeakPressureAboveStiffness {
        /// Stiffness, Pa.
        stiffness: f64,
        /// Penetration, length.
        penetration: f64,
        /// ε of the law, length.
        smoothing_length: f64,
    },
    /// The matrix is not positive definite although everything is supported: the bodies buckle or tear.
    Unstable {
        /// Part of the full load.
        load: f64,
    },
    /// A cell has been inverted, at every length of the step.
    Inverted {
        /// Part of the full load.
        load: f64,
        /// The cell, counted over all parts, where it is known.
        cell: Option<usize>,
    },
    /// The contact found no answer.
    Contact(fmc_contact::Error),
    /// An array has another length than there are nodes.
    Length {
        /// Number of nodes.
        expected: usize,
        /// Its length.
        found: usize,
    },
    /// A degree of freedom is joined twice, joined and held, or carried and not held.
    Joined {
        /// Node.
        node: usize,
        /// Axis.
        axis: usize,
    },
    /// Whoever watched broke it off.
    Interrupted,
}

impl fmt::Display for StaticsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotConverged { load, iterations, residual, why } => {
                write!(
                    f,
                    "not converged at load {load:.4}: residual {residual:.2e} after {iterations} iterations: {why}"
                )
            }
            Self::Unsupported { body, motion } => {
                write!(f, "'{body}' is not supported: neither supports nor contact resist its {motion}")
            }
            Self::Adrift { body, motion, has_friction } => {
                let rubs = if *has_friction { ". Its load may be more than friction holds" } else { "" };
                write!(
                    f,
                    "'{body}' does not come to rest: its load drives it on, by {motion}, and neither supports nor other bodies stop it{rubs}"
                )
            }
            Self::PeakPressureAboveStiffness { stiffness, penetration, smoothing_length } => write!(
                f,
                "the contact pressure exceeds the stiffness k = {stiffness:e} of the linear law, so that the bodies pass \
                 through one another: the penetration is {penetration:.2e}, with a smoothing length of \
                 {smoothing_length:.1e}; raise k above the peak pressure"
            ),
            Self::Unstable { load } => write!(f, "the bodies are not stable at load {load:.4}: they buckle"),
            Self::Inverted { load, cell } => {
                let cell = cell.map_or("a cell".into(), |cell| format!("cell {cell}"));
                write!(f, "{cell} is inverted at load {load:.4}")
            }
            Self::Contact(error) => write!(f, "{error}"),
            Self::Length { expected, found } => {
                write!(f, "an array has {found} entries, but there are {expected} nodes")
            }
            Self::Joined { node, axis } => write!(
                f,
                "axis {axis} of node {node} is joined twice, joined and held, or carried and not held; joined ones ascend"
            ),
            Self::Interrupted => write!(f, "interrupted"),
        }
    }
}

impl std::error::Error for StaticsError {}

impl From<fmc_contact::Error> for StaticsError {
    fn from(error: fmc_contact::Error) -> Self {
        Self::Contact(error)
    }
}
