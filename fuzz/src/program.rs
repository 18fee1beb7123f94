//! A host's program: a mesh, options, and calls in any order.

// Fields say what they are; the header says what they mean.
#![allow(missing_docs)]

mod options;
mod shape;

pub use options::{Options, PairOptions};
pub use shape::{Fault, Pose, Shape};

use crate::mesh::Mesh;
use crate::number::Number;
use arbitrary::Arbitrary;

/// Everything from the context's creation to its end.
#[derive(Arbitrary, Clone, Debug)]
pub struct Program {
    /// What the context is made from.
    pub mesh: Mesh,
    /// Whether node numbers are of 64 bits.
    pub is_wide: bool,
    /// Options at creation.
    pub options: Options,
    /// Calls, the first [`MOST_CALLS`] of which are made.
    pub calls: Vec<Call>,
}

/// Calls of one program that are made.
pub const MOST_CALLS: usize = 12;

/// How a host's array lies in memory.
#[derive(Arbitrary, Clone, Copy, Debug)]
pub enum Layout {
    Rows,
    Padded,
    Columns,
    Reversed,
    /// All nodes in one place: fine to read, not to write.
    Repeated,
}

/// Which pointer of a call is NULL, if any.
pub type Hole = u8;

/// One call, or a few that belong together.
#[derive(Arbitrary, Clone, Debug)]
pub enum Call {
    Evaluate {
        read: Layout,
        write: Layout,
        add: bool,
        hole: Hole,
    },
    Tangent {
        read: Layout,
        flags: u8,
        hole: Hole,
    },
    Rows {
        read: Layout,
        flags: u8,
        hole: Hole,
    },
    KeepPattern {
        keep: u8,
    },
    Gaps {
        reach: Number,
        hole: Hole,
    },
    StableStep {
        mass: Number,
        hole: Hole,
    },
    ContactStep {
        /// Every degree of freedom whose bit is set is on the list, the others are held; bit 15: they are not.
        which: u16,
        /// Adds this to the first number of the list.
        shift: i8,
        stiffness: Number,
        coupling: Number,
        residual: Number,
        tolerance: Number,
        fault: Fault,
        hole: Hole,
    },
    Condensation {
        /// Equations that are kept, which array is damaged, and the number of equations.
        which: u16,
        shift: i8,
        value: Number,
        hole: Hole,
    },
    Fields {
        read: Layout,
        hole: Hole,
    },
    KeepPatches {
        forget: bool,
        hole: Hole,
    },
    SetOptions(Options),
    SetByName {
        key: u8,
        value: [u8; 6],
    },
    AddObstacle {
        shape: Shape,
        pose: Option<Pose>,
        hole: Hole,
    },
    SetPose {
        obstacle: u8,
        pose: Pose,
    },
    RemoveObstacle {
        obstacle: u8,
        hole: Hole,
    },
    SetPair {
        options: PairOptions,
        hole: Hole,
    },
    Move {
        node: u8,
        axis: u8,
        to: Number,
    },
    Getters {
        index: u8,
        hole: Hole,
    },
    SetLog {
        calls_back: bool,
    },
    Stateless {
        hole: Hole,
    },
    FromFacets {
        facets: Vec<u8>,
        /// Types of two blocks of facets; edges or triangles in one array where the first is even.
        types: [u8; 2],
        is_wide: bool,
    },
    Suggest {
        dim: u8,
        values: [Number; 3],
    },
    Texts {
        status: i32,
        feature: [u8; 5],
    },
    /// Coordinates without deformation: those in force, by a factor along the first axis.
    SetReference {
        read: Layout,
        factor: Number,
        hole: Hole,
    },
    /// Begins or commits a step, freezes friction, or reads and sets the slip.
    Step {
        what: u8,
        read: Layout,
        value: Number,
        hole: Hole,
    },
    SetSymmetryNodes {
        nodes: Vec<u8>,
        hole: Hole,
    },
    /// Shares the work with ranks that are all this one; `fails`: with a communicator that fails, for one evaluation.
    Share {
        rank: i8,
        size: i8,
        fails: bool,
        hole: Hole,
    },
    /// The mesh in one part, beside the same whole.
    InParts {
        reach: Number,
        hole: Hole,
    },
    /// Moves surfaces out; `damage` goes into a field of the first multiplier.
    Augment {
        reach: Number,
        enough: Number,
        damage: Number,
        hole: Hole,
    },
}
