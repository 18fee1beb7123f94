//! Status codes, one per cause.

use crate::Error;
use std::ffi::{CStr, c_char};

/// Result of a call. 0 is success. Every cause of failure has a separate code. `fmc_last_error` returns a text with the
/// offending indices and values.
///
/// An error leaves the outputs and the context unchanged. Codes are never reused.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum fmc_status {
    /// Success.
    FMC_OK = 0,
    /// A pointer is NULL where the function needs one, or where a length is not zero.
    FMC_ERROR_NULL_POINTER = 1,
    /// A pointer is not a multiple of its element's size.
    FMC_ERROR_MISALIGNED_POINTER = 2,
    /// The length of an array does not match the mesh, or cannot be addressed.
    FMC_ERROR_LENGTH = 3,
    /// The host's array is too short for the output.
    FMC_ERROR_BUFFER_TOO_SMALL = 4,
    /// Strides for which entries of an output share memory, or that cannot be addressed.
    FMC_ERROR_STRIDE = 5,
    /// A dimension other than 2 and 3, or a cell type of another dimension than the coordinates.
    FMC_ERROR_DIMENSION = 6,
    /// Not a value of `fmc_cell_type`, or of `fmc_facet_type`.
    FMC_ERROR_UNKNOWN_CELL_TYPE = 7,
    /// A cell or facet names a node that does not exist.
    FMC_ERROR_NODE_OUT_OF_RANGE = 8,
    /// A coordinate is NaN or infinite.
    FMC_ERROR_NON_FINITE_COORDINATE = 9,
    /// A cell or facet names one node twice.
    FMC_ERROR_REPEATED_NODE = 10,
    /// A cell is inverted, or a facet of second order is folded.
    FMC_ERROR_INVERTED_CELL = 11,
    /// A cell or facet has no length, area or volume.
    FMC_ERROR_ZERO_MEASURE = 12,
    /// A surface given by facets is not closed.
    FMC_ERROR_OPEN_SURFACE = 13,
    /// More than two facets meet at an edge (2D: at a node), or more than two cells at a face.
    FMC_ERROR_NON_MANIFOLD = 14,
    /// Two neighbouring facets have opposite orientations.
    FMC_ERROR_INCONSISTENT_ORIENTATION = 15,
    /// The facets of a body point inwards.
    FMC_ERROR_INVERTED_SURFACE = 16,
    /// There are no cells and no facets.
    FMC_ERROR_EMPTY = 17,
    /// A parameter is not positive and finite, or an exponent not at least 1.
    FMC_ERROR_NOT_POSITIVE = 18,
    /// No option of this name.
    FMC_ERROR_UNKNOWN_OPTION = 19,
    /// A struct was not initialised by its `_init` function, or comes from an unknown version of the header.
    FMC_ERROR_STRUCT_SIZE = 20,
    /// A position or scale is not finite, a scale not positive, or a rotation not orthonormal with determinant +1.
    FMC_ERROR_BAD_POSE = 21,
    /// No obstacle of this index.
    FMC_ERROR_OBSTACLE_OUT_OF_RANGE = 22,
    /// No body, pair or warning of this index in the last evaluation, or no evaluation yet.
    FMC_ERROR_INDEX_OUT_OF_RANGE = 23,
    /// The estimator, or this build of the library, does not support this.
    FMC_ERROR_UNSUPPORTED = 24,
    /// A signed-distance callback failed, or left a value that is not finite.
    FMC_ERROR_SIGNED_DISTANCE = 25,
    /// The spacing is too small for the bodies.
    FMC_ERROR_TOO_MANY_FIBERS = 26,
    /// The threads could not be started, or more than 1024 were requested.
    FMC_ERROR_THREADS = 27,
    /// The context is in use by another call: from another thread, or from a callback of this one.
    FMC_ERROR_BUSY = 28,
    /// A volume, energy, force or entry of the tangent exceeds the range of a double.
    FMC_ERROR_OVERFLOW = 29,
    /// A panic was caught: a defect of this library. The text gives the reason and the place.
    FMC_ERROR_PANIC = 30,
    /// The points of a convex hull lie in one plane (2D: on one line), or their hull cannot be found to rounding.
    FMC_ERROR_DEGENERATE_HULL = 31,
    /// A height field has fewer than two points along an axis.
    FMC_ERROR_TOO_FEW_HEIGHTS = 32,
    /// A height is NaN or infinite.
    FMC_ERROR_NON_FINITE_HEIGHT = 33,
    /// A compound has no parts.
    FMC_ERROR_EMPTY_COMPOUND = 34,
    /// The mass of a node that feels contact is not positive.
    FMC_ERROR_NOT_POSITIVE_MASS = 35,
    /// No body of this index.
    FMC_ERROR_BODY_OUT_OF_RANGE = 36,
    /// The obstacle of this index was removed.
    FMC_ERROR_OBSTACLE_REMOVED = 37,
    /// The facets of a pair lie in so many layers that `exact` would cut them into too many pieces.
    FMC_ERROR_TOO_MANY_PIECES = 38,
    /// Lines along the boundary of a signed-distance obstacle would need more steps than are taken.
    FMC_ERROR_UNFINISHED_LINES = 39,
    /// Friction is on, but no step has begun: call `fmc_context_begin_step`.
    FMC_ERROR_NO_STEP = 40,
    /// An elastic slip is NaN or infinite.
    FMC_ERROR_NON_FINITE_SLIP = 41,
    /// A node lies beyond the axis, with axisymmetry: its first coordinate is negative.
    FMC_ERROR_NEGATIVE_RADIUS = 42,
    /// Two cells, or two facets of a surface, do not conform: an edge or a face is divided, or has a node in its middle, in
    /// only one of them.
    FMC_ERROR_NON_CONFORMING = 43,
    /// The stiffness of bodies and contact together is singular to rounding: a body is not held.
    FMC_ERROR_SINGULAR_STIFFNESS = 44,
    /// The stiffness of bodies and contact together is not positive definite.
    FMC_ERROR_INDEFINITE_STIFFNESS = 45,
    /// A list of degrees of freedom names one that does not exist.
    FMC_ERROR_DOF_OUT_OF_RANGE = 46,
    /// A list of degrees of freedom does not ascend, or names one that another list has.
    FMC_ERROR_REPEATED_DOF = 47,
    /// A stiffness or a residual that was given is NaN or infinite.
    FMC_ERROR_NON_FINITE_STIFFNESS = 48,
    /// A host's function that places its nodes failed.
    FMC_ERROR_PLACE = 49,
    /// The rank of a communicator is not from 0 to one less than its size.
    FMC_ERROR_BAD_RANK = 50,
    /// A communicator's function failed.
    FMC_ERROR_COMMUNICATION = 51,
    /// The evaluation failed on another rank, which has the cause.
    FMC_ERROR_ON_OTHER_RANK = 52,
    /// Ranks that share the work of a context were given different coordinates, options or obstacles, or made different calls.
    FMC_ERROR_RANKS_DIFFER = 53,
    /// Coordinates at which a part of a mesh that was not gathered may be in contact.
    FMC_ERROR_NOT_GATHERED = 54,
    /// The stiffness of bodies is not positive definite: they are unsupported, or buckle.
    FMC_ERROR_NOT_POSITIVE_DEFINITE = 55,
    /// A matrix that has to be symmetric is not.
    FMC_ERROR_UNSYMMETRIC = 56,
    /// There are no factors of a matrix: none was given, or the last one could not be factorised.
    FMC_ERROR_NOT_FACTORISED = 57,
    /// An `index_size` other than 4 and 8, or two of one call that differ.
    FMC_ERROR_INDEX_SIZE = 58,
    /// An option, a kind or a switch has no such value.
    FMC_ERROR_BAD_VALUE = 59,
    /// A bit of `flags` that the function does not have.
    FMC_ERROR_UNKNOWN_FLAG = 60,
    /// Two options exclude one another, or one would have no effect in combination with the rest.
    FMC_ERROR_OPTIONS_CONFLICT = 61,
    /// A reserved field is not zero: an option of a later version of the library.
    FMC_ERROR_RESERVED_FIELD = 62,
    /// The contact has no stiffness: option `stiffness` is 0, and none was found from the bodies' matrix.
    FMC_ERROR_NO_STIFFNESS = 63,
    /// The call was ended by the host (`fmc_context_set_interrupt`).
    FMC_ERROR_INTERRUPTED = 64,
    /// Memory for large arrays could not be allocated. If memory runs out for small ones, or the system has overcommitted it, the
    /// process ends.
    FMC_ERROR_MEMORY = 65,
    /// Two tied bodies face one another nowhere within reach.
    FMC_ERROR_UNTIED = 66,
    /// The law of the host on an interface or of friction failed, or wrote a number that is not finite; or its derivative is
    /// wrong (`fmc_own_law_check`, `fmc_friction_law_check`).
    FMC_ERROR_INTERFACE_LAW = 67,
}

use fmc_status::*;

/// Code and name of every status, in the order of the codes.
const NAMES: &[(fmc_status, &CStr)] = &[
    (FMC_OK, c"FMC_OK"),
    (FMC_ERROR_NULL_POINTER, c"FMC_ERROR_NULL_POINTER"),
    (FMC_ERROR_MISALIGNED_POINTER, c"FMC_ERROR_MISALIGNED_POINTER"),
    (FMC_ERROR_LENGTH, c"FMC_ERROR_LENGTH"),
    (FMC_ERROR_BUFFER_TOO_SMALL, c"FMC_ERROR_BUFFER_TOO_SMALL"),
    (FMC_ERROR_STRIDE, c"FMC_ERROR_STRIDE"),
    (FMC_ERROR_DIMENSION, c"FMC_ERROR_DIMENSION"),
    (FMC_ERROR_UNKNOWN_CELL_TYPE, c"FMC_ERROR_UNKNOWN_CELL_TYPE"),
    (FMC_ERROR_NODE_OUT_OF_RANGE, c"FMC_ERROR_NODE_OUT_OF_RANGE"),
    (FMC_ERROR_NON_FINITE_COORDINATE, c"FMC_ERROR_NON_FINITE_COORDINATE"),
    (FMC_ERROR_REPEATED_NODE, c"FMC_ERROR_REPEATED_NODE"),
    (FMC_ERROR_INVERTED_CELL, c"FMC_ERROR_INVERTED_CELL"),
    (FMC_ERROR_ZERO_MEASURE, c"FMC_ERROR_ZERO_MEASURE"),
    (FMC_ERROR_OPEN_SURFACE, c"FMC_ERROR_OPEN_SURFACE"),
    (FMC_ERROR_NON_MANIFOLD, c"FMC_ERROR_NON_MANIFOLD"),
    (FMC_ERROR_INCONSISTENT_ORIENTATION, c"FMC_ERROR_INCONSISTENT_ORIENTATION"),
    (FMC_ERROR_INVERTED_SURFACE, c"FMC_ERROR_INVERTED_SURFACE"),
    (FMC_ERROR_EMPTY, c"FMC_ERROR_EMPTY"),
    (FMC_ERROR_NOT_POSITIVE, c"FMC_ERROR_NOT_POSITIVE"),
    (FMC_ERROR_UNKNOWN_OPTION, c"FMC_ERROR_UNKNOWN_OPTION"),
    (FMC_ERROR_STRUCT_SIZE, c"FMC_ERROR_STRUCT_SIZE"),
    (FMC_ERROR_BAD_POSE, c"FMC_ERROR_BAD_POSE"),
    (FMC_ERROR_OBSTACLE_OUT_OF_RANGE, c"FMC_ERROR_OBSTACLE_OUT_OF_RANGE"),
    (FMC_ERROR_INDEX_OUT_OF_RANGE, c"FMC_ERROR_INDEX_OUT_OF_RANGE"),
    (FMC_ERROR_UNSUPPORTED, c"FMC_ERROR_UNSUPPORTED"),
    (FMC_ERROR_SIGNED_DISTANCE, c"FMC_ERROR_SIGNED_DISTANCE"),
    (FMC_ERROR_TOO_MANY_FIBERS, c"FMC_ERROR_TOO_MANY_FIBERS"),
    (FMC_ERROR_THREADS, c"FMC_ERROR_THREADS"),
    (FMC_ERROR_BUSY, c"FMC_ERROR_BUSY"),
    (FMC_ERROR_OVERFLOW, c"FMC_ERROR_OVERFLOW"),
    (FMC_ERROR_PANIC, c"FMC_ERROR_PANIC"),
    (FMC_ERROR_DEGENERATE_HULL, c"FMC_ERROR_DEGENERATE_HULL"),
    (FMC_ERROR_TOO_FEW_HEIGHTS, c"FMC_ERROR_TOO_FEW_HEIGHTS"),
    (FMC_ERROR_NON_FINITE_HEIGHT, c"FMC_ERROR_NON_FINITE_HEIGHT"),
    (FMC_ERROR_EMPTY_COMPOUND, c"FMC_ERROR_EMPTY_COMPOUND"),
    (FMC_ERROR_NOT_POSITIVE_MASS, c"FMC_ERROR_NOT_POSITIVE_MASS"),
    (FMC_ERROR_BODY_OUT_OF_RANGE, c"FMC_ERROR_BODY_OUT_OF_RANGE"),
    (FMC_ERROR_OBSTACLE_REMOVED, c"FMC_ERROR_OBSTACLE_REMOVED"),
    (FMC_ERROR_TOO_MANY_PIECES, c"FMC_ERROR_TOO_MANY_PIECES"),
    (FMC_ERROR_UNFINISHED_LINES, c"FMC_ERROR_UNFINISHED_LINES"),
    (FMC_ERROR_NO_STEP, c"FMC_ERROR_NO_STEP"),
    (FMC_ERROR_NON_FINITE_SLIP, c"FMC_ERROR_NON_FINITE_SLIP"),
    (FMC_ERROR_NEGATIVE_RADIUS, c"FMC_ERROR_NEGATIVE_RADIUS"),
    (FMC_ERROR_NON_CONFORMING, c"FMC_ERROR_NON_CONFORMING"),
    (FMC_ERROR_SINGULAR_STIFFNESS, c"FMC_ERROR_SINGULAR_STIFFNESS"),
    (FMC_ERROR_INDEFINITE_STIFFNESS, c"FMC_ERROR_INDEFINITE_STIFFNESS"),
    (FMC_ERROR_DOF_OUT_OF_RANGE, c"FMC_ERROR_DOF_OUT_OF_RANGE"),
    (FMC_ERROR_REPEATED_DOF, c"FMC_ERROR_REPEATED_DOF"),
    (FMC_ERROR_NON_FINITE_STIFFNESS, c"FMC_ERROR_NON_FINITE_STIFFNESS"),
    (FMC_ERROR_PLACE, c"FMC_ERROR_PLACE"),
    (FMC_ERROR_BAD_RANK, c"FMC_ERROR_BAD_RANK"),
    (FMC_ERROR_COMMUNICATION, c"FMC_ERROR_COMMUNICATION"),
    (FMC_ERROR_ON_OTHER_RANK, c"FMC_ERROR_ON_OTHER_RANK"),
    (FMC_ERROR_RANKS_DIFFER, c"FMC_ERROR_RANKS_DIFFER"),
    (FMC_ERROR_NOT_GATHERED, c"FMC_ERROR_NOT_GATHERED"),
    (FMC_ERROR_NOT_POSITIVE_DEFINITE, c"FMC_ERROR_NOT_POSITIVE_DEFINITE"),
    (FMC_ERROR_UNSYMMETRIC, c"FMC_ERROR_UNSYMMETRIC"),
    (FMC_ERROR_NOT_FACTORISED, c"FMC_ERROR_NOT_FACTORISED"),
    (FMC_ERROR_INDEX_SIZE, c"FMC_ERROR_INDEX_SIZE"),
    (FMC_ERROR_BAD_VALUE, c"FMC_ERROR_BAD_VALUE"),
    (FMC_ERROR_UNKNOWN_FLAG, c"FMC_ERROR_UNKNOWN_FLAG"),
    (FMC_ERROR_OPTIONS_CONFLICT, c"FMC_ERROR_OPTIONS_CONFLICT"),
    (FMC_ERROR_RESERVED_FIELD, c"FMC_ERROR_RESERVED_FIELD"),
    (FMC_ERROR_NO_STIFFNESS, c"FMC_ERROR_NO_STIFFNESS"),
    (FMC_ERROR_INTERRUPTED, c"FMC_ERROR_INTERRUPTED"),
    (FMC_ERROR_MEMORY, c"FMC_ERROR_MEMORY"),
    (FMC_ERROR_UNTIED, c"FMC_ERROR_UNTIED"),
    (FMC_ERROR_INTERFACE_LAW, c"FMC_ERROR_INTERFACE_LAW"),
];

impl From<&Error> for fmc_status {
    fn from(error: &Error) -> Self {
        match error {
            Error::Length { .. } => FMC_ERROR_LENGTH,
            Error::Dimension { .. } => FMC_ERROR_DIMENSION,
            Error::NodeOutOfRange { .. } => FMC_ERROR_NODE_OUT_OF_RANGE,
            Error::NonFiniteCoordinate { .. } => FMC_ERROR_NON_FINITE_COORDINATE,
            Error::RepeatedNode { .. } => FMC_ERROR_REPEATED_NODE,
            // A host does the same about both.
            Error::InvertedCell { .. } | Error::InvertedCells { .. } | Error::FoldedCell { .. } => {
                FMC_ERROR_INVERTED_CELL
            }
            Error::ZeroMeasure { .. } => FMC_ERROR_ZERO_MEASURE,
            Error::OpenSurface { .. } => FMC_ERROR_OPEN_SURFACE,
            Error::NonManifold { .. } | Error::RepeatedCell { .. } => FMC_ERROR_NON_MANIFOLD,
            Error::InconsistentOrientation { .. } => FMC_ERROR_INCONSISTENT_ORIENTATION,
            Error::InvertedSurface { .. } => FMC_ERROR_INVERTED_SURFACE,
            Error::Empty => FMC_ERROR_EMPTY,
            Error::NoSuchNumber { .. } => FMC_ERROR_BAD_VALUE,
            Error::NotPositive { .. } | Error::BadEntry { .. } => FMC_ERROR_NOT_POSITIVE,
            Error::Collapsed { .. } => FMC_ERROR_BAD_VALUE,
            Error::NotPositiveMass { .. } => FMC_ERROR_NOT_POSITIVE_MASS,
            Error::BadPose { .. } => FMC_ERROR_BAD_POSE,
            Error::ObstacleOutOfRange { .. } => FMC_ERROR_OBSTACLE_OUT_OF_RANGE,
            Error::ObstacleRemoved { .. } => FMC_ERROR_OBSTACLE_REMOVED,
            Error::BodyOutOfRange { .. } => FMC_ERROR_BODY_OUT_OF_RANGE,
            Error::OfPair { cause, .. } => Self::from(&**cause),
            Error::NonFiniteSlip { .. } => FMC_ERROR_NON_FINITE_SLIP,
            Error::NegativeRadius { .. } => FMC_ERROR_NEGATIVE_RADIUS,
            Error::UnknownOutOfRange { .. } | Error::NoSuchRow { .. } => FMC_ERROR_INDEX_OUT_OF_RANGE,
            Error::NonConforming { .. } => FMC_ERROR_NON_CONFORMING,
            Error::SingularStiffness { .. } => FMC_ERROR_SINGULAR_STIFFNESS,
            Error::IndefiniteStiffness { .. } => FMC_ERROR_INDEFINITE_STIFFNESS,
            Error::NotPositiveDefinite { .. } => FMC_ERROR_NOT_POSITIVE_DEFINITE,
            Error::Unsymmetric { .. } => FMC_ERROR_UNSYMMETRIC,
            Error::NotFactorised => FMC_ERROR_NOT_FACTORISED,
            Error::DofOutOfRange { .. } => FMC_ERROR_DOF_OUT_OF_RANGE,
            Error::RepeatedDof { .. } => FMC_ERROR_REPEATED_DOF,
            Error::NonFiniteStiffness { .. } => FMC_ERROR_NON_FINITE_STIFFNESS,
            Error::Place { .. } => FMC_ERROR_PLACE,
            Error::NoStep => FMC_ERROR_NO_STEP,
            Error::NoStiffness => FMC_ERROR_NO_STIFFNESS,
            Error::Untied { .. } => FMC_ERROR_UNTIED,
            Error::InterfaceLaw(_) | Error::FrictionLaw(_) => FMC_ERROR_INTERFACE_LAW,
            Error::Interrupted => FMC_ERROR_INTERRUPTED,
            Error::Memory { .. } => FMC_ERROR_MEMORY,
            Error::DegenerateHull { .. } => FMC_ERROR_DEGENERATE_HULL,
            Error::TooFewHeights { .. } => FMC_ERROR_TOO_FEW_HEIGHTS,
            Error::NonFiniteHeight { .. } => FMC_ERROR_NON_FINITE_HEIGHT,
            Error::EmptyCompound => FMC_ERROR_EMPTY_COMPOUND,
            Error::Unsupported { .. } => FMC_ERROR_UNSUPPORTED,
            Error::SignedDistance { .. } | Error::SteepDistance { .. } => FMC_ERROR_SIGNED_DISTANCE,
            Error::TooManyFibers { .. } => FMC_ERROR_TOO_MANY_FIBERS,
            Error::TooManyPieces { .. } => FMC_ERROR_TOO_MANY_PIECES,
            Error::UnfinishedLines { .. } => FMC_ERROR_UNFINISHED_LINES,
            Error::Overflow { .. } => FMC_ERROR_OVERFLOW,
            Error::Threads { .. } => FMC_ERROR_THREADS,
            Error::BadRank { .. } => FMC_ERROR_BAD_RANK,
            Error::Communication { .. } => FMC_ERROR_COMMUNICATION,
            Error::OnOtherRank { .. } => FMC_ERROR_ON_OTHER_RANK,
            Error::RanksDiffer { .. } => FMC_ERROR_RANKS_DIFFER,
            Error::NotGathered { .. } => FMC_ERROR_NOT_GATHERED,
        }
    }
}

/// The status of a number.
pub(crate) fn status_of(code: i32) -> Option<fmc_status> {
    NAMES.iter().map(|(status, _)| *status).find(|status| *status as i32 == code)
}

/// Name of a status, such as "FMC_ERROR_NULL_POINTER"; "FMC_UNKNOWN_STATUS" for any other number.
///
/// The text is constant and never freed. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn fmc_status_name(status: i32) -> *const c_char {
    NAMES.iter().find(|(code, _)| *code as i32 == status).map_or(c"FMC_UNKNOWN_STATUS", |(_, name)| name).as_ptr()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_has_its_name() {
        assert!(NAMES.is_sorted_by_key(|(code, _)| *code as i32));
        for (code, name) in NAMES {
            assert_eq!(name.to_str().unwrap(), format!("{code:?}"));
        }
        assert_eq!(NAMES.last().unwrap().0, FMC_ERROR_INTERFACE_LAW);
    }

    #[test]
    fn every_error_has_a_status_of_its_own() {
        let nodes = [0, 1];
        let errors = [
            Error::Length { array: "coords", expected: 1, found: 2 },
            Error::Dimension { block: 0, expected: 2, found: 3 },
            Error::NodeOutOfRange { cell: 0, node: -1, node_count: 3 },
            Error::NonFiniteCoordinate { node: 0, axis: 1 },
            Error::RepeatedNode { cell: 0, node: 1 },
            Error::InvertedCell { cell: 0 },
            Error::ZeroMeasure { cell: 0 },
            Error::OpenSurface { facet: 0, nodes },
            Error::NonManifold { facet: 0, nodes },
            Error::InconsistentOrientation { facet: 0, nodes },
            Error::InvertedSurface { body: 0 },
            Error::Empty,
            Error::NotPositive { name: "stiffness", value: 0.0 },
            Error::NotPositiveMass { node: 0, value: 0.0 },
            Error::BadPose { obstacle: 0 },
            Error::ObstacleOutOfRange { obstacle: 0, count: 0 },
            Error::BodyOutOfRange { body: 0, count: 0 },
            Error::ObstacleRemoved { obstacle: 0 },
            Error::NoStep,
            Error::NoStiffness,
            Error::Untied { bodies: [0, 1], distances: [0.1, 0.3], held: "tied" },
            Error::InterfaceLaw(crate::LawFault { bodies: [0, 1], point: Some(2), cause: "of this".to_owned() }),
            Error::NonFiniteSlip { facet: 0 },
            Error::NegativeRadius { node: 0, radius: -1.0 },
            Error::NonConforming { cells: [0, 1] },
            Error::SingularStiffness { dof: 0 },
            Error::IndefiniteStiffness { dof: 0, pivot: -1.0 },
            Error::DofOutOfRange { dof: -1, count: 0 },
            Error::RepeatedDof { dof: 0 },
            Error::NonFiniteStiffness { array: "residual", entry: 0 },
            Error::Place { code: 1 },
            Error::UnknownOutOfRange { row: 0, unknown: 1, count: 1 },
            Error::DegenerateHull { point_count: 3 },
            Error::TooFewHeights { axis: 0, count: 1 },
            Error::NonFiniteHeight { point: 0 },
            Error::EmptyCompound,
            Error::Unsupported { what: "this" },
            Error::SignedDistance { obstacle: 0, point: 0 },
            Error::TooManyFibers { needed: 2.0, limit: 1.0 },
            Error::TooManyPieces { sides: [("body", 0), ("body", 1)], limit: 1 },
            Error::UnfinishedLines { obstacle: 0, lines: 1, steps: 1 },
            Error::Overflow { quantity: "energy", value: f64::INFINITY },
            Error::Threads { threads: 1 },
            Error::BadRank { rank: 1, size: 1 },
            Error::Communication { code: 1 },
            Error::OnOtherRank { rank: 1 },
            Error::RanksDiffer { rank: 1 },
            Error::NotGathered { body: 1 },
            Error::NotPositiveDefinite { equation: 0 },
            Error::Unsymmetric { row: 1, column: 0 },
            Error::NotFactorised,
        ];
        let mut codes: Vec<i32> = errors.iter().map(|error| fmc_status::from(error) as i32).collect();
        assert!(!codes.contains(&(FMC_OK as i32)));
        codes.sort_unstable();
        codes.dedup();
        assert_eq!(codes.len(), errors.len());
    }

    /// A law of the host is one cause, wherever it acts.
    #[test]
    fn laws_of_the_host_have_one_status() {
        let sides = [("body", 0), ("obstacle", 1)];
        let friction = Error::FrictionLaw(crate::FrictionFault { sides, facet: Some(2), cause: "of this".to_owned() });
        assert_eq!(fmc_status::from(&friction) as i32, FMC_ERROR_INTERFACE_LAW as i32);
    }
}
