//! A host's program: a mesh, options, and calls in any order.

// Fields say what they are; the header says what they mean.
#![allow(missing_docs)]

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

/// Values of options; small numbers mostly, so that they mean something.
#[derive(Arbitrary, Clone, Debug)]
pub struct Options {
    pub stiffness: Number,
    pub exponent: Option<Number>,
    pub smoothing_length: Option<Number>,
    pub friction: Option<Number>,
    pub friction_stiffness: Option<Number>,
    pub cohesion: Option<Number>,
    pub spacing: Option<Number>,
    pub fiber_length: Option<Number>,
    pub fiber_count: Option<u8>,
    pub seed: u64,
    /// Law, estimator, pattern, weights, momentum correction, self-contact, check of the cells: by twos of bits, 3 being no value.
    pub choices: u16,
    pub index_base: bool,
    /// Two threads.
    pub is_threaded: bool,
    /// A struct that no `_init` function has seen.
    pub is_raw: u8,
}

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

/// Where an obstacle stands.
#[derive(Arbitrary, Clone, Debug)]
pub struct Pose {
    pub position: [Number; 3],
    pub axis: [Number; 3],
    pub scale: Option<Number>,
    /// The rotation as it comes, instead of one along the axis.
    pub rotation: Option<[Number; 9]>,
}

/// An obstacle.
#[derive(Arbitrary, Clone, Debug)]
pub enum Shape {
    HalfSpace,
    Ball(Number),
    Cuboid([Number; 3]),
    Cylinder(Number, Number),
    Cone(Number, Number),
    Capsule(Number, Number),
    /// A simplex or, where numbers are added, facets of any kind.
    Polytope {
        corners: [[Number; 3]; 4],
        facets: Vec<u8>,
        is_wide: bool,
    },
    /// Points of any kind.
    ConvexHull(Vec<[Number; 3]>),
    /// Heights over a grid of so many points by 2.
    HeightField {
        count: u8,
        heights: [Number; 8],
        thickness: Number,
    },
    /// Parts by number of the shape and size.
    Compound(Vec<(u8, Number)>),
    /// A ball by its signed distance, and how the callback misbehaves.
    SignedDistance {
        radius: Number,
        fault: Fault,
    },
}

/// Options of a pair.
#[derive(Arbitrary, Clone, Debug)]
pub struct PairOptions {
    /// Kind and index of both sides, in one number each.
    pub sides: [u8; 2],
    /// One less is the law.
    pub law: u8,
    pub stiffness: Number,
    pub exponent: Option<Number>,
    pub smoothing_length: Option<Number>,
    pub excluded: u8,
    pub gap_offset: Option<Number>,
}

/// What a host's callback does wrong.
#[derive(Arbitrary, Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    None,
    /// Returns this.
    Returns(i32),
    /// Leaves all as it was.
    WritesNothing,
    WritesNan,
    NoGradient,
    /// Grows faster than distance.
    Steep,
    /// Calls the context that calls it.
    CallsBack,
}

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
