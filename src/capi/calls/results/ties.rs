//! Bodies that are tied.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::{MatrixRoom, Room};
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::tie::{fmc_tie, fmc_tie_node};
use crate::capi::structs::view::fmc_coords;
use std::ffi::c_void;

/// The tie of two bodies, indices for `fmc_context_body_resultant`, as found without deformation; for bodies that slide and do not
/// separate, as found last. `fmc_context_set_pair_options` makes them. For other bodies all numbers are zero.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BODY_OUT_OF_RANGE`; `FMC_ERROR_UNTIED` if reference coordinates that were set later
/// leave no tied face; `FMC_ERROR_BUSY`. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_tie(
    context: *const fmc_context,
    a: usize,
    b: usize,
    tie: *mut fmc_tie,
) -> fmc_status {
    entry(|| {
        let output = Output::required("tie", tie)?;
        // SAFETY: the host passes a context.
        let found = in_either!(&unsafe { read(context) }?.session, one => one.tie([a, b]))?;
        // SAFETY: the host passes an output that may be written.
        unsafe { output.write(found.into()) };
        Ok(())
    })
}

/// Traction and jump of all ties at `coords`, by pair and node of the holding side, mostly the side with the larger facets; for bodies that
/// do not separate, along the normal only.
///
/// `count` becomes their number; `rows` has room for `capacity`. NULL with capacity 0: only the number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH`, `FMC_ERROR_NON_FINITE_COORDINATE`,
/// `FMC_ERROR_NO_STIFFNESS`, `FMC_ERROR_UNTIED` as `fmc_context_tie`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_tie_nodes(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    rows: *mut fmc_tie_node,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, a view, and room for `capacity` rows.
        unsafe {
            write(context, |state| {
                let coords = reference("coords", coords)?;
                let found = in_either!(&mut state.session, one => one.tie_nodes(coords, state.index_base))?;
                room.write("nodes of ties", "rows", &found, rows)
            })
        }
    })
}

/// All ties as equations, for hosts that eliminate unknowns or use their own multipliers: sum of `values` times coordinates = 0 for
/// every row, in compressed rows, a row for each axis of each of `fmc_context_tie_nodes`. Row r has the entries from `row_offsets[r]`
/// to `row_offsets[r + 1]`, in ascending order of their columns, which are degrees of freedom as in `fmc_context_tangent`. Offsets and
/// columns count from the option `index_base`.
///
/// `offset_count` becomes the number of offsets, one more than there are rows, and `count` the number of entries. `row_offsets` has
/// room for `offset_capacity`, `cols` and `values` for `capacity`. An array that is NULL with capacity 0 is not written: only its
/// number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH` where a number does not fit into the context's
/// numbers. `FMC_ERROR_UNSUPPORTED` where a tie keeps a gap, since its rows then depend on the rotation of facets, and with bodies that do
/// not separate. `FMC_ERROR_UNTIED` as `fmc_context_tie`, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once on one
/// context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_tie_constraints(
    context: *const fmc_context,
    row_offsets: *mut c_void,
    offset_capacity: usize,
    offset_count: *mut usize,
    cols: *mut c_void,
    values: *mut f64,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let (offsets, entries) = (Room::new(offset_capacity, offset_count)?, Room::new(capacity, count)?);
        // SAFETY: the host passes a context.
        let state = unsafe { read(context) }?;
        let room = MatrixRoom { row_offsets, offsets, cols, values, entries, size: state.index_size };
        let found = in_either!(&state.session, one => one.tie_constraints())?;
        // SAFETY: the host guarantees the room that it says.
        unsafe {
            room.write(&found.row_starts, found.cols.iter().copied(), found.dof_count, &found.values, state.index_base)
        }
    })
}
