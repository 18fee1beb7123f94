//! Weighted gaps as constraints.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::list::{MatrixRoom, Room};
use crate::capi::boundary::pointer::reference;
use crate::capi::boundary::status::fmc_status;
use crate::capi::context::state::{fmc_context, read, write};
use crate::capi::structs::gap_constraint::{KeptGaps, fmc_gap_constraint};
use crate::capi::structs::view::fmc_coords;
use std::ffi::c_void;

/// The weighted gaps at `coords` of all nodes that have a facet within `reach` of a partner, apart or overlapping, for an
/// augmented Lagrangian, an interior point method or a preconditioner. They do not depend on law and estimator.
///
/// Both bodies of a pair have rows, ordered by pair, side and node; a host that wants one side only takes the rows of one
/// body. A body has no gaps over itself. With cells of second order rows are points, columns nodes.
///
/// `count` becomes the number of rows; `rows` has room for `capacity`. NULL with capacity 0: only the number is returned, and the
/// next call at the same coordinates does not search again. The gaps are kept for `fmc_context_gap_gradient`.
///
/// Errors: as `fmc_context_evaluate`, `FMC_ERROR_NOT_POSITIVE` for `reach`, and `FMC_ERROR_BUFFER_TOO_SMALL`; no output is then
/// written. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_gap_constraints(
    context: *mut fmc_context,
    coords: *const fmc_coords,
    reach: f64,
    rows: *mut fmc_gap_constraint,
    capacity: usize,
    count: *mut usize,
) -> fmc_status {
    entry(|| {
        let room = Room::new(capacity, count)?;
        // SAFETY: the host passes a context, a view, and room for `capacity` rows.
        unsafe {
            write(context, |state| {
                let found = state.gap_constraints(reference("coords", coords)?, reach)?;
                room.write("gap constraints", "rows", &found.rows, rows)
            })
        }
    })
}

/// The derivative of the gaps of the last call, d gap / d x, in compressed rows. Row r has the entries from `row_offsets[r]` to
/// `row_offsets[r + 1]`, in ascending order of their columns, which are degrees of freedom as in `fmc_context_tangent`. Offsets
/// and columns count from the option `index_base`. The columns are the degrees of freedom that feel the contact. Pressures p on
/// the rows act with the nodal forces sum over r of p_r times row r.
///
/// `offset_count` becomes the number of offsets, one more than there are rows, and `count` the number of entries. `row_offsets` has
/// room for `offset_capacity`, `cols` and `values` for `capacity`. An array that is NULL with capacity 0 is not written: only its
/// number is returned.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUFFER_TOO_SMALL`, `FMC_ERROR_LENGTH` where a number does not fit into the context's
/// numbers, `FMC_ERROR_BUSY`; no output is then written. Threads: several at once on one context, as long as no call changes it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_gap_gradient(
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
        let KeptGaps { row_starts, cols, values, dof_count, .. } = state.last_gaps();
        // SAFETY: the host guarantees the room that it says.
        unsafe { room.write(row_starts, cols.iter().copied(), *dof_count, values, state.index_base) }
    })
}
