//! Why a simulation cannot start or go on.

use super::step_limit::StepLimit;
use std::fmt;

/// What stops a simulation. After an error of a step the simulation is as it was before that step.
#[derive(Clone, Debug, PartialEq)]
pub enum DynamicsError {
    /// The contact found no answer.
    Contact {
        /// Step at which.
        step: u64,
        /// Time at which.
        time: f64,
        /// The contact's own error.
        error: fmc_contact::Error,
    },
    /// A cell has been inverted, at one of its corners at least.
    InvertedCell {
        /// Step at which.
        step: u64,
        /// Time at which.
        time: f64,
        /// The cell, counted over all parts, where it is known.
        cell: Option<usize>,
    },
    /// A displacement or velocity is NaN or infinite: the motion is not stable.
    NonFinite {
        /// Step at which.
        step: u64,
        /// Time at which.
        time: f64,
        /// Node.
        node: usize,
    },
    /// The step asked for exceeds the stable one.
    StepTooLarge {
        /// Step asked for.
        asked: f64,
        /// The limit, and what makes it.
        limit: StepLimit,
    },
    /// No step can be chosen: the bodies have no stiffness.
    NoLimit,
    /// A value of the setup that must be finite and not negative (a step: positive) is not.
    Value {
        /// Which.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// An array of the setup has another length than there are nodes.
    Length {
        /// Which.
        array: &'static str,
        /// Number of nodes.
        expected: usize,
        /// Its length.
        found: usize,
    },
    /// A support names a node that does not exist.
    Support {
        /// Node named.
        node: usize,
    },
    /// A part has cells of second order: its masses are there, but no bound of the step in contact.
    SecondOrder {
        /// Name of the part.
        part: String,
    },
    /// The model's surface, the contact's options or an obstacle is refused.
    Setup(fmc_contact::Error),
    /// A checkpoint cannot be written or read.
    Checkpoint(CheckpointError),
}

/// What is wrong with a checkpoint.
#[derive(Clone, Debug, PartialEq)]
pub enum CheckpointError {
    /// The file cannot be written or read.
    File {
        /// The file.
        path: String,
        /// The system's words.
        reason: String,
    },
    /// It is no checkpoint, or it is damaged.
    Damaged,
    /// It was written by another version of the format.
    Version {
        /// Its version.
        found: u32,
    },
    /// It belongs to another model or to other settings.
    OtherModel,
    /// It was made with another step.
    OtherStep {
        /// Step of the file.
        found: f64,
        /// Step asked for.
        asked: f64,
    },
}

impl fmt::Display for DynamicsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Contact { step, time, error } => write!(f, "contact at step {step}, time {time:.6e}: {error}"),
            Self::InvertedCell { step, time, cell } => {
                let cell = cell.map_or("a cell".into(), |cell| format!("cell {cell}"));
                write!(f, "{cell} is inverted at step {step}, time {time:.6e}: the step, or the mesh, is too coarse")
            }
            Self::NonFinite { step, time, node } => {
                write!(f, "the motion of node {node} is not finite at step {step}, time {time:.6e}: it is not stable")
            }
            Self::StepTooLarge { asked, limit } => {
                write!(f, "a step of {asked:.4e} exceeds the limit of {limit}")
            }
            Self::NoLimit => write!(f, "the bodies have no stiffness, so that a step must be given"),
            Self::Value { name, value } => write!(f, "'{name}' is {value}, which is not allowed"),
            Self::Length { array, expected, found } => {
                write!(f, "'{array}' has {found} entries, but there are {expected} nodes")
            }
            Self::Support { node } => write!(f, "a support names node {node}, which does not exist"),
            Self::SecondOrder { part } => write!(f, "{part}: bodies of second order can be at rest, not in motion"),
            Self::Setup(error) => write!(f, "{error}"),
            Self::Checkpoint(error) => write!(f, "{error}"),
        }
    }
}

impl fmt::Display for CheckpointError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File { path, reason } => write!(f, "{path}: {reason}"),
            Self::Damaged => write!(f, "the file is no checkpoint, or it is damaged"),
            Self::Version { found } => write!(f, "the checkpoint has version {found} of the format, which is not read"),
            Self::OtherModel => write!(f, "the checkpoint belongs to another model or to other settings"),
            Self::OtherStep { found, asked } => {
                write!(f, "the checkpoint was made with a step of {found:e}, asked for is {asked:e}")
            }
        }
    }
}

impl std::error::Error for DynamicsError {}
impl std::error::Error for CheckpointError {}

impl From<CheckpointError> for DynamicsError {
    fn from(error: CheckpointError) -> Self {
        Self::Checkpoint(error)
    }
}
