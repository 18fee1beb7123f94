//! What a host does about a status, in six classes.

use super::status::fmc_status::{self, *};
use super::status::status_of;
use fmc_status_class_value::*;

/// Class of a status: how a host reacts to it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum fmc_status_class_value {
    /// Success.
    FMC_CLASS_OK = 0,
    /// An argument, an option or an array is wrong: correct the call. A retry does not help.
    FMC_CLASS_INPUT = 1,
    /// The mesh or a shape is invalid, or became invalid as it deformed: correct it, or take a shorter step.
    FMC_CLASS_GEOMETRY = 2,
    /// The solution diverged, or a matrix cannot be factorised: take a shorter step, or support the bodies.
    FMC_CLASS_NUMERICAL = 3,
    /// More threads, lines, pieces or steps than possible: reduce the request.
    FMC_CLASS_RESOURCE = 4,
    /// Calls in the wrong order, or ranks that do not match.
    FMC_CLASS_PROTOCOL = 5,
    /// A defect of this library.
    FMC_CLASS_INTERNAL = 6,
}

fn class_of(status: fmc_status) -> fmc_status_class_value {
    match status {
        FMC_OK => FMC_CLASS_OK,
        FMC_ERROR_NULL_POINTER
        | FMC_ERROR_MISALIGNED_POINTER
        | FMC_ERROR_LENGTH
        | FMC_ERROR_BUFFER_TOO_SMALL
        | FMC_ERROR_STRIDE
        | FMC_ERROR_DIMENSION
        | FMC_ERROR_UNKNOWN_CELL_TYPE
        | FMC_ERROR_NODE_OUT_OF_RANGE
        | FMC_ERROR_REPEATED_NODE
        | FMC_ERROR_EMPTY
        | FMC_ERROR_NOT_POSITIVE
        | FMC_ERROR_INDEX_SIZE
        | FMC_ERROR_UNKNOWN_OPTION
        | FMC_ERROR_BAD_VALUE
        | FMC_ERROR_UNKNOWN_FLAG
        | FMC_ERROR_OPTIONS_CONFLICT
        | FMC_ERROR_RESERVED_FIELD
        | FMC_ERROR_STRUCT_SIZE
        | FMC_ERROR_BAD_POSE
        | FMC_ERROR_OBSTACLE_OUT_OF_RANGE
        | FMC_ERROR_OBSTACLE_REMOVED
        | FMC_ERROR_BODY_OUT_OF_RANGE
        | FMC_ERROR_INDEX_OUT_OF_RANGE
        | FMC_ERROR_UNSUPPORTED
        | FMC_ERROR_SIGNED_DISTANCE
        | FMC_ERROR_INTERFACE_LAW
        | FMC_ERROR_TOO_FEW_HEIGHTS
        | FMC_ERROR_NON_FINITE_HEIGHT
        | FMC_ERROR_EMPTY_COMPOUND
        | FMC_ERROR_NOT_POSITIVE_MASS
        | FMC_ERROR_NON_FINITE_SLIP
        | FMC_ERROR_DOF_OUT_OF_RANGE
        | FMC_ERROR_REPEATED_DOF
        | FMC_ERROR_UNSYMMETRIC
        | FMC_ERROR_PLACE
        | FMC_ERROR_BAD_RANK => FMC_CLASS_INPUT,
        FMC_ERROR_INVERTED_CELL
        | FMC_ERROR_ZERO_MEASURE
        | FMC_ERROR_OPEN_SURFACE
        | FMC_ERROR_NON_MANIFOLD
        | FMC_ERROR_INCONSISTENT_ORIENTATION
        | FMC_ERROR_INVERTED_SURFACE
        | FMC_ERROR_NON_CONFORMING
        | FMC_ERROR_NEGATIVE_RADIUS
        | FMC_ERROR_DEGENERATE_HULL
        | FMC_ERROR_UNTIED => FMC_CLASS_GEOMETRY,
        FMC_ERROR_NON_FINITE_COORDINATE
        | FMC_ERROR_OVERFLOW
        | FMC_ERROR_NON_FINITE_STIFFNESS
        | FMC_ERROR_SINGULAR_STIFFNESS
        | FMC_ERROR_INDEFINITE_STIFFNESS
        | FMC_ERROR_NOT_POSITIVE_DEFINITE => FMC_CLASS_NUMERICAL,
        FMC_ERROR_TOO_MANY_FIBERS
        | FMC_ERROR_TOO_MANY_PIECES
        | FMC_ERROR_UNFINISHED_LINES
        | FMC_ERROR_THREADS
        | FMC_ERROR_MEMORY => FMC_CLASS_RESOURCE,
        FMC_ERROR_BUSY
        | FMC_ERROR_NO_STEP
        | FMC_ERROR_NO_STIFFNESS
        | FMC_ERROR_INTERRUPTED
        | FMC_ERROR_NOT_FACTORISED
        | FMC_ERROR_COMMUNICATION
        | FMC_ERROR_ON_OTHER_RANK
        | FMC_ERROR_RANKS_DIFFER
        | FMC_ERROR_NOT_GATHERED => FMC_CLASS_PROTOCOL,
        FMC_ERROR_PANIC => FMC_CLASS_INTERNAL,
    }
}

/// Class of a status, a value of `fmc_status_class_value`; `FMC_CLASS_INTERNAL` for a number that is not a status. A host
/// that branches on classes tolerates statuses of later versions of the library. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn fmc_status_class(status: i32) -> i32 {
    status_of(status).map_or(FMC_CLASS_INTERNAL, class_of) as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::capi::boundary::status::fmc_status_name;
    use std::ffi::CStr;

    /// Rows of the tables: "| `FMC_ERROR_EMPTY` | input | what to do |".
    #[test]
    fn the_page_of_errors_names_every_status_with_its_class() {
        let page = include_str!("../../../docs/errors.md");
        let (mut count, words) = (0, ["", "input", "geometry", "numerical", "resource", "protocol", "internal"]);
        for status in (1..1000).filter(|status| status_of(*status).is_some()) {
            // SAFETY: a constant text.
            let name = unsafe { CStr::from_ptr(fmc_status_name(status)) }.to_str().expect("ASCII");
            let row = format!("| `{name}` | {} |", words[fmc_status_class(status) as usize]);
            assert_eq!(page.matches(&row).count(), 1, "docs/errors.md has no row that begins with {row}");
            count += 1;
        }
        assert!(count > 55);
        assert_eq!((fmc_status_class(0), fmc_status_class(-1)), (FMC_CLASS_OK as i32, FMC_CLASS_INTERNAL as i32));
    }
}
